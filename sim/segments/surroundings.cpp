#include "sim/segments/surroundings.h"

#include <array>
#include <cmath>
#include <limits>

#include "sim/segments/segment.h"

namespace eod::sim {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

namespace {

constexpr double kUnitRoundoff = 6e-8;
constexpr float kNever = std::numeric_limits<float>::infinity();

float RoundedDown(double value) { return std::nextafter(static_cast<float>(value), -kNever); }
float RoundedUp(double value) { return std::nextafter(static_cast<float>(value), kNever); }

}  // namespace

void Surroundings::Reserve() {
  if (!columns_.empty()) return;
  entries_.reserve(kMaxBlocks);
  found_.resize(size_t{2} * kMaxBlocks + 1);
  work_.resize(1);
  columns_.resize(size_t{6} * kMaxBlocks);
  for (size_t axis = 0; axis < 3; ++axis) {
    boxes_.low[axis] = &columns_[axis * kMaxBlocks];
    boxes_.high[axis] = &columns_[(3 + axis) * kMaxBlocks];
  }
}

void Surroundings::Gather(const BlockTree& tree, const Kernels& kernels, const AlignedBox3d& box,
                          uint64_t revision) {
  Reserve();
  revision_ = revision;
  region_ = AlignedBox3d(box.min().array() - kMargin, box.max().array() + kMargin);
  origin_ = box.center();
  for (int axis = 0; axis < 3; ++axis) half_size_[axis] = RoundedDown(region_.sizes()[axis] / 2);
  entries_.clear();
  usable_ = box.sizes().maxCoeff() <= kWidest;
  if (usable_) CollectBlocks(tree, kernels);
  if (!usable_) entries_.clear();
  Describe(tree);
}

bool Surroundings::IsWorthGathering(const AlignedBox3d& box) {
  const bool is_near = last_asked_.intersects(
      AlignedBox3d(box.min().array() - kMargin, box.max().array() + kMargin));
  last_asked_ = box;
  return is_near || region_.intersects(box);
}

bool Surroundings::Covers(const SegmentPacket& packet) const {
  bool inside = true;
  for (int axis = 0; axis < 3; ++axis) {
    inside &= -half_size_[axis] <= packet.low[axis] && packet.high[axis] <= half_size_[axis];
  }
  return inside;
}

void Surroundings::CollectBlocks(const BlockTree& tree, const Kernels& kernels) {
  if (tree.nodes.empty()) return;
  float low[3], high[3];
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = RoundedDown(region_.min()[axis]);
    high[axis] = RoundedUp(region_.max()[axis]);
  }
  std::array<int32_t, kMaxWaiting> waiting{};
  size_t count = 1;
  while (count > 0) {
    const Node& node = tree.nodes[static_cast<size_t>(waiting[--count])];
    uint32_t bits = kernels.OverlappingChildren(node, low, high);
    for (; bits != 0; bits &= bits - 1) {
      const int32_t child = node.child[__builtin_ctz(bits)];
      if (child >= 0) {
        waiting[count++] = child;
      } else if (entries_.size() < kMaxBlocks) {
        entries_.push_back(NearBlock{});
        entries_.back().block = ~child;
      } else {
        usable_ = false;
        return;
      }
    }
  }
}

/// Fills in what the packets are tested against, relative to the list's own origin.
void Surroundings::Describe(const BlockTree& tree) {
  const double region_reach = region_.sizes().maxCoeff();
  for (size_t i = 0; i < entries_.size(); ++i) {
    NearBlock& entry = entries_[i];
    const BlockPlace& place = tree.places[static_cast<size_t>(entry.block)];
    const Vector3d offset = place.origin - origin_;
    const double reach = region_reach + offset.lpNorm<Eigen::Infinity>() +
                         static_cast<double>(place.half_size.maxCoeff());
    const auto error = static_cast<float>(4 * kUnitRoundoff * reach + kEndTolerance);
    entry.classes = place.classes;
    entry.triangles = (1u << place.count) - 1;
    entry.slack = SlackTerms::Of(place.longest_edge, error);
    for (size_t axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<Eigen::Index>(axis);
      entry.offset[axis] = static_cast<float>(offset[at]);
      entry.low[axis] = entry.offset[axis] - error;
      entry.high[axis] = entry.offset[axis] + error;
      columns_[axis * kMaxBlocks + i] =
          RoundedDown(offset[at] - static_cast<double>(place.half_size[at]));
      columns_[(3 + axis) * kMaxBlocks + i] =
          RoundedUp(offset[at] + static_cast<double>(place.half_size[at]));
    }
  }
  boxes_.count = static_cast<int>((entries_.size() + 7) / 8 * 8);
  for (size_t i = entries_.size(); i < static_cast<size_t>(boxes_.count); ++i) {
    for (size_t column = 0; column < 6; ++column) columns_[column * kMaxBlocks + i] = kNever;
  }
}

}  // namespace eod::sim
