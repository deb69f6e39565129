#include "sim/segments/packet_cast.h"

#include <algorithm>
#include <limits>

namespace eod::sim {

using Eigen::Vector3d;

namespace {

/// [m] by which a packet's box is grown: more than float can lose within the widest surroundings.
constexpr double kBoxMargin = 5e-6;

}  // namespace

PacketCast::PacketCast(std::span<const SegmentQuery> queries, int first_query)
    : queries_(queries), first_query_(first_query) {
  Vector3d low = queries[0].start, high = low;
  for (const SegmentQuery& query : queries) {
    const Vector3d end = query.start + query.length * query.direction;
    low = low.cwiseMin(query.start).cwiseMin(end);
    high = high.cwiseMax(query.start).cwiseMax(end);
  }
  box_ = {low.array() - kBoxMargin, high.array() + kBoxMargin};
}

void PacketCast::Pack(const Vector3d& origin) {
  double longest = 0;
  for (size_t i = 0; i < 8; ++i) {
    // Unused lanes repeat the first segment; their answers are masked out.
    const SegmentQuery& query = queries_[i < queries_.size() ? i : 0];
    longest = std::max(longest, query.length);
    for (size_t axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<Eigen::Index>(axis);
      packet_.start[axis][i] = static_cast<float>(query.start[at] - origin[at]);
      packet_.way[axis][i] = static_cast<float>(query.length * query.direction[at]);
    }
  }
  for (size_t axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<Eigen::Index>(axis);
    packet_.low[axis] = static_cast<float>(box_.min()[at] - origin[at]);
    packet_.high[axis] = static_cast<float>(box_.max()[at] - origin[at]);
  }
  PackPairs();
  packet_.longest = static_cast<float>(longest * (1 + 1e-6));
  packet_.diagonal = static_cast<float>(box_.diagonal().norm() * (1 + 1e-6));
  packet_.lanes = (1u << queries_.size()) - 1;
}

void PacketCast::PackPairs() {
  constexpr auto kMargin = static_cast<float>(kBoxMargin);
  packet_.pairs = static_cast<int>((queries_.size() + 1) / 2);
  for (size_t axis = 0; axis < 3; ++axis) {
    std::array<float, 8> low{}, high{};
    for (size_t i = 0; i < 8; ++i) {
      const float start = packet_.start[axis][i], end = start + packet_.way[axis][i];
      low[i] = start < end ? start : end;
      high[i] = start < end ? end : start;
    }
    for (size_t pair = 0; pair < 4; ++pair) {
      // The second of the last pair may be unused: then it repeats the first segment.
      const size_t one = 2 * pair, other = one + 1 < queries_.size() ? one + 1 : one;
      packet_.pair_low[pair][axis] = std::min(low[one], low[other]) - kMargin;
      packet_.pair_high[pair][axis] = std::max(high[one], high[other]) + kMargin;
    }
  }
}

void PacketCast::Run(const BlockTree& tree, const Kernels& kernels, CastMemory& memory,
                     std::span<SegmentHit> hits) {
  Surroundings& near = memory.surroundings;
  Pack(near.origin());
  const int count = kernels.OverlappingBoxes(near.boxes(), packet_.low, packet_.high, near.found());
  if (count == 0) return;
  std::array<TriangleChoice, 8> choices;
  for (size_t i = 0; i < queries_.size(); ++i) choices[i] = TriangleChoice(queries_[i]);
  for (int i = 0; i < count; ++i) {
    Open(tree, kernels, near.entry(near.found()[i]), choices, memory);
  }
  for (size_t i = 0; i < queries_.size(); ++i) {
    if (choices[i].found()) hits[i] = choices[i].Hit(tree);
  }
}

void PacketCast::Open(const BlockTree& tree, const Kernels& kernels,
                      const Surroundings::Entry& entry, std::span<TriangleChoice> choices,
                      CastMemory& memory) const {
  const auto block = static_cast<size_t>(entry.block);
  const BlockPlace& place = tree.places[block];
  if (!Accepts(queries_[0].class_mask, place.classes)) return;
  ++memory.counters.blocks;
  std::array<Candidate, kBlockSize> found;
  const int count = kernels.TestPacket(tree.blocks[block], place, packet_, entry.offset,
                                       entry.error, found.data(), memory.counters.candidates);
  for (int i = 0; i < count; ++i) {
    const Candidate& candidate = found[static_cast<size_t>(i)];
    for (uint32_t lanes = candidate.lanes; lanes != 0; lanes &= lanes - 1) {
      const int lane = __builtin_ctz(lanes);
      choices[static_cast<size_t>(lane)].Offer(tree, block, candidate.place, first_query_ + lane,
                                               memory);
    }
  }
}

}  // namespace eod::sim
