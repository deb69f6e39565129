#include "sim/segments/surroundings.h"

#include <algorithm>
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
  collected_.reserve(kMaxBlocks);
  classes_.reserve(kMaxBlocks / 8);
}

void Surroundings::Gather(const BlockTree& tree, const Kernels& kernels, const AlignedBox3d& box,
                          uint64_t revision) {
  Reserve();
  revision_ = revision;
  region_ = AlignedBox3d(box.min().array() - kMargin, box.max().array() + kMargin);
  origin_ = box.center();
  for (int axis = 0; axis < 3; ++axis) half_size_[axis] = RoundedDown(region_.sizes()[axis] / 2);
  usable_ = box.sizes().maxCoeff() <= kWidest;
  collected_.clear();
  if (usable_) CollectBlocks(tree, kernels);
  if (usable_) ListByClass(tree);
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
    uint32_t bits = kernels.overlapping_children(node, low, high);
    for (; bits != 0; bits &= bits - 1) {
      const int32_t child = node.child[__builtin_ctz(bits)];
      if (child >= 0) {
        waiting[count++] = child;
      } else if (collected_.size() < kMaxBlocks) {
        collected_.push_back(~child);
      } else {
        usable_ = false;
        return;
      }
    }
  }
}

void Surroundings::ListByClass(const BlockTree& tree) {
  const auto class_of = [&](int32_t block) {
    return tree.places[static_cast<size_t>(block)].classes;
  };
  std::sort(collected_.begin(), collected_.end(), [&](int32_t one, int32_t other) {
    return class_of(one) != class_of(other) ? class_of(one) < class_of(other) : one < other;
  });
  entries_.clear();
  classes_.clear();
  for (size_t i = 0; i < collected_.size() && usable_;) {
    const size_t first = entries_.size();
    ClassBoxes& list = classes_.emplace_back();
    list.classes = class_of(collected_[i]);
    while (i < collected_.size() && class_of(collected_[i]) == list.classes && usable_) {
      Append(tree, collected_[i++]);
    }
    PadToEight();
    list.boxes.first = static_cast<int>(first);
    list.boxes.count = static_cast<int>(entries_.size() - first);
    for (size_t axis = 0; axis < 3; ++axis) {
      list.boxes.low[axis] = &columns_[axis * kMaxBlocks + first];
      list.boxes.high[axis] = &columns_[(3 + axis) * kMaxBlocks + first];
    }
  }
}

/// What packets are tested against, relative to the list's own origin.
void Surroundings::Append(const BlockTree& tree, int32_t block) {
  const BlockPlace& place = tree.places[static_cast<size_t>(block)];
  const Vector3d offset = place.origin - origin_;
  const double reach = region_.sizes().maxCoeff() + offset.lpNorm<Eigen::Infinity>() +
                       static_cast<double>(place.half_size.maxCoeff());
  const auto error = static_cast<float>(4 * kUnitRoundoff * reach + kEndTolerance);
  const size_t i = entries_.size();
  NearBlock& entry = entries_.emplace_back();
  entry.block = block;
  entry.triangles = (1u << place.count) - 1;
  entry.slack = SlackTerms::Of(place.longest_edge, error);
  for (size_t axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<Eigen::Index>(axis);
    entry.offset[axis] = static_cast<float>(offset[at]);
    entry.low[axis] = entry.offset[axis] - error;
    entry.high[axis] = entry.offset[axis] + error;
    const auto half_size = static_cast<double>(place.half_size[at]);
    columns_[axis * kMaxBlocks + i] = RoundedDown(offset[at] - half_size);
    columns_[(3 + axis) * kMaxBlocks + i] = RoundedUp(offset[at] + half_size);
  }
  usable_ = entries_.size() < kMaxBlocks - 8;
}

void Surroundings::PadToEight() {
  while (entries_.size() % 8 != 0) {
    const size_t i = entries_.size();
    entries_.emplace_back();
    for (size_t column = 0; column < 6; ++column) columns_[column * kMaxBlocks + i] = kNever;
  }
}

}  // namespace eod::sim
