#include "sim/segments/packet_cast.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace eod::sim {

using Eigen::Vector3d;

namespace {

/// [m] by which boxes are grown: more than float can lose within the widest surroundings.
constexpr float kBoxMargin = 5e-6F;
constexpr double kRoundedUp = 1 + 1e-6;

float Least(float a, float b) { return a < b ? a : b; }
float Largest(float a, float b) { return a > b ? a : b; }

}  // namespace

PacketCast::PacketCast(std::span<const SegmentQuery> queries, int first_query,
                       const Vector3d& origin)
    : queries_(queries), first_query_(first_query) {
  double longest = 0;
  for (size_t i = 0; i < queries.size(); ++i) {
    Pack(i, queries[i], origin);
    longest = std::max(longest, queries[i].length);
  }
  // Unused places repeat the first segment; their answers are masked out.
  for (size_t i = queries.size(); i < 8; ++i) {
    for (size_t axis = 0; axis < 3; ++axis) {
      packet_.start[axis][i] = packet_.start[axis][0];
      packet_.way[axis][i] = packet_.way[axis][0];
    }
  }
  packet_.longest = static_cast<float>(longest * kRoundedUp);
  packet_.lanes = (1u << queries.size()) - 1;
  PackBoxes();
}

void PacketCast::Pack(size_t place, const SegmentQuery& query, const Vector3d& origin) {
  for (size_t axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<Eigen::Index>(axis);
    packet_.start[axis][place] = static_cast<float>(query.start[at] - origin[at]);
    packet_.way[axis][place] = static_cast<float>(query.length * query.direction[at]);
  }
}

void PacketCast::PackBoxes() {
  packet_.pairs = static_cast<int>((queries_.size() + 1) / 2);
  float squared_diagonal = 0;
  for (size_t axis = 0; axis < 3; ++axis) {
    alignas(32) float low[8], high[8];
    for (size_t i = 0; i < 8; ++i) {
      const float start = packet_.start[axis][i], end = start + packet_.way[axis][i];
      low[i] = Least(start, end);
      high[i] = Largest(start, end);
    }
    for (size_t pair = 0; pair < 4; ++pair) {
      // The second of the last pair may be unused, a repeated first segment far from its pair.
      const size_t one = 2 * pair, other = one + 1 < queries_.size() ? one + 1 : one;
      packet_.pair_low[pair][axis] = Least(low[one], low[other]) - kBoxMargin;
      packet_.pair_high[pair][axis] = Largest(high[one], high[other]) + kBoxMargin;
    }
    const auto& pair_low = packet_.pair_low;
    const auto& pair_high = packet_.pair_high;
    packet_.low[axis] = Least(Least(pair_low[0][axis], pair_low[1][axis]),
                              Least(pair_low[2][axis], pair_low[3][axis]));
    packet_.high[axis] = Largest(Largest(pair_high[0][axis], pair_high[1][axis]),
                                 Largest(pair_high[2][axis], pair_high[3][axis]));
    const float size = packet_.high[axis] - packet_.low[axis];
    squared_diagonal += size * size;
  }
  packet_.diagonal = std::sqrt(squared_diagonal) * static_cast<float>(kRoundedUp);
}

void PacketCast::Run(const BlockTree& tree, const Kernels& kernels, CastMemory& memory,
                     std::span<SegmentHit> hits) const {
  Surroundings& near = memory.surroundings;
  const int count = kernels.OverlappingBoxes(near.boxes(), packet_, near.found());
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
