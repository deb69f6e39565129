#include "sim/segments/packet_cast.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace eod::sim {

using Eigen::Vector3d;

namespace {

/// [m] by which boxes are grown: more than float can lose within the widest surroundings.
constexpr float kBoxMargin = 5e-6F;

static_assert(offsetof(SegmentQuery, start) == SegmentNumbers::kStart * sizeof(double));
static_assert(offsetof(SegmentQuery, direction) == SegmentNumbers::kDirection * sizeof(double));
static_assert(offsetof(SegmentQuery, length) == SegmentNumbers::kLength * sizeof(double));
// Four numbers are read from each of start and direction.
static_assert(SegmentNumbers::kDirection + 4 <= SegmentNumbers::kLength + 1);

}  // namespace

PacketCast::PacketCast(const Kernels& kernels, std::span<const SegmentQuery> queries,
                       int first_query, const Vector3d& origin)
    : kernels_(kernels), queries_(queries), first_query_(first_query) {
  const size_t count = queries.size();
  std::array<const double*, 8> segments;
  for (size_t pair = 0; pair < 4; ++pair) {
    const size_t one = 2 * pair < count ? 2 * pair : 0;
    segments[pair] = queries[one].start.data();
    segments[pair + 4] = queries[2 * pair + 1 < count ? one + 1 : one].start.data();
  }
  const std::array<double, 4> from = {origin.x(), origin.y(), origin.z(), 0};
  valid_ = kernels.Pack(segments.data(), static_cast<int>(count), from.data(), kBoxMargin, packet_);
}

void PacketCast::Run(const BlockTree& tree, CastMemory& memory, std::span<SegmentHit> hits) const {
  Surroundings& near = memory.surroundings;
  NearBox* const found = near.found();
  const int all = kernels_.OverlappingBoxes(near.boxes(), packet_, found);
  int count = 0;
  for (int i = 0; i < all; ++i) {
    found[count] = found[i];
    count += Accepts(queries_[0].class_mask, near.blocks()[found[i].index].classes) ? 1 : 0;
  }
  if (count == 0) return;
  memory.counters.blocks += static_cast<uint64_t>(count);
  Choices choices;
  for (int first = 0; first < count; first += PacketWork::kMostBoxes) {
    const int part = std::min(count - first, PacketWork::kMostBoxes);
    Test(tree, {found + first, static_cast<size_t>(part)}, choices, memory);
  }
  for (uint32_t begun = choices.begun; begun != 0; begun &= begun - 1) {
    const auto segment = static_cast<size_t>(__builtin_ctz(begun));
    const TriangleChoice& choice = choices.of[segment];
    if (choice.found()) hits[segment] = choice.Hit(tree);
  }
}

void PacketCast::Test(const BlockTree& tree, std::span<const NearBox> boxes, Choices& choices,
                      CastMemory& memory) const {
  PacketWork& work = memory.surroundings.work();
  const int count = kernels_.TestPacket(tree.blocks.data(), memory.surroundings.blocks(),
                                        boxes.data(), static_cast<int>(boxes.size()), packet_, work,
                                        memory.counters.candidates);
  for (int i = 0; i < count; ++i) {
    const Candidate& candidate = work.candidates[i];
    const NearBox& box = boxes[static_cast<size_t>(candidate.box)];
    const auto block = static_cast<size_t>(memory.surroundings.blocks()[box.index].block);
    for (uint32_t bits = candidate.places; bits != 0; bits &= bits - 1) {
      const int segment = SegmentPacket::SegmentAt(__builtin_ctz(bits));
      TriangleChoice& choice = choices.of[static_cast<size_t>(segment)];
      if ((choices.begun >> segment & 1) == 0) choice.Begin(queries_[static_cast<size_t>(segment)]);
      choices.begun |= 1u << segment;
      choice.Offer(tree, block, candidate.triangle, first_query_ + segment, memory);
    }
  }
}

}  // namespace eod::sim
