#include "sim/segments/line_walk.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/segments/hit_choice.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

constexpr double kUnitRoundoff = 6e-8;

class Walk {
 public:
  Walk(const BlockTree& tree, const Kernels& kernels, const SegmentQuery& segment, int query,
       TriangleChoice& choice, CastMemory& memory)
      : tree_(tree),
        kernels_(kernels),
        segment_(segment),
        query_(query),
        choice_(choice),
        memory_(memory),
        farthest_(WantsFarthest(segment)),
        // The farthest hit is the nearest one seen from the end.
        direction_(farthest_ ? Vector3d(-segment.direction) : segment.direction),
        start_(farthest_ ? Vector3d(segment.start + segment.length * segment.direction)
                         : segment.start) {
    const double reach = start_.lpNorm<Eigen::Infinity>() + tree.reach;
    line_.slack = static_cast<float>(4 * kUnitRoundoff * reach + kEndTolerance);
    for (int axis = 0; axis < 3; ++axis) {
      const double d = direction_[axis];
      line_.start[axis] = static_cast<float>(start_[axis]);
      line_.inverse[axis] = static_cast<float>(1 / (std::abs(d) > 1e-25 ? d : 1e-25));
    }
  }

  void Run();

 private:
  struct Waiting {
    int32_t child;
    float enter;  ///< [m] from start_
  };

  void Push(const Node& node);
  void Open(size_t block, double enter);
  /// How far hits are still of interest [m].
  float Reach() const {
    double reach = segment_.length + kEndTolerance;
    if (choice_.found() && segment_.hit_rule != HitRule::kAll) {
      reach = farthest_ ? segment_.length - choice_.range() : choice_.range();
    }
    return static_cast<float>(reach * (1 + 2 * kUnitRoundoff) + kEndTolerance);
  }

  const BlockTree& tree_;
  const Kernels& kernels_;
  const SegmentQuery& segment_;
  int query_;
  TriangleChoice& choice_;
  CastMemory& memory_;
  bool farthest_;
  Vector3d direction_, start_;
  Line line_{};
  std::array<Waiting, kMaxWaiting> waiting_;
  size_t count_ = 0;
};

void Walk::Run() {
  if (tree_.nodes.empty()) return;
  waiting_[count_++] = {0, 0};
  while (count_ > 0) {
    const Waiting next = waiting_[--count_];
    if (next.enter > Reach()) continue;
    if (next.child >= 0) {
      Push(tree_.nodes[static_cast<size_t>(next.child)]);
    } else {
      const int32_t block = ~next.child;
      Open(static_cast<size_t>(block), static_cast<double>(next.enter));
    }
  }
}

/// Puts the children that are entered on the pile, the nearest on top.
void Walk::Push(const Node& node) {
  alignas(32) float enter[kFanOut];
  uint32_t bits = kernels_.entered_children(node, line_, Reach(), enter);
  const size_t bottom = count_;
  for (; bits != 0; bits &= bits - 1) {
    const auto i = static_cast<size_t>(__builtin_ctz(bits));
    if (!Accepts(segment_.class_mask, node.classes[i])) continue;
    size_t at = count_++;
    for (; at > bottom && waiting_[at - 1].enter < enter[i]; --at) waiting_[at] = waiting_[at - 1];
    waiting_[at] = {node.child[i], enter[i]};
  }
}

void Walk::Open(size_t block, double enter) {
  const BlockPlace& place = tree_.places[block];
  const Vector3d at = start_ + enter * direction_ - place.origin;
  const double rest = std::max(segment_.length - enter, 0.0) + kEndTolerance;
  LinePiece piece{};
  for (int axis = 0; axis < 3; ++axis) {
    piece.start[axis] = static_cast<float>(at[axis]);
    piece.way[axis] = static_cast<float>(rest * direction_[axis]);
  }
  piece.way_length = static_cast<float>(rest * (1 + 2 * kUnitRoundoff));
  const double size =
      at.lpNorm<Eigen::Infinity>() + static_cast<double>(place.half_size.maxCoeff());
  const auto error = static_cast<float>(4 * kUnitRoundoff * size + kEndTolerance);
  ++memory_.counters.blocks;
  memory_.counters.candidates += static_cast<uint64_t>(place.count);
  uint32_t bits = kernels_.test_line(tree_.blocks[block], place, piece, error);
  for (; bits != 0; bits &= bits - 1) {
    choice_.Offer(tree_, block, __builtin_ctz(bits), query_, memory_);
  }
}

}  // namespace

void WalkAlong(const BlockTree& tree, const Kernels& kernels, const SegmentQuery& segment,
               int query, TriangleChoice& choice, CastMemory& memory) {
  Walk(tree, kernels, segment, query, choice, memory).Run();
}

}  // namespace eod::sim
