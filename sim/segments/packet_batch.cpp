#include "sim/segments/packet_batch.h"

#include <algorithm>
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

PacketBatch::Answer PacketBatch::Add(size_t first, size_t end) {
  if (count_ == kMostPackets) Run();
  const auto queries = queries_.subspan(first, end - first);
  const size_t count = queries.size();
  std::array<const double*, 8> segments;
  for (size_t pair = 0; pair < 4; ++pair) {
    const size_t one = 2 * pair < count ? 2 * pair : 0;
    segments[pair] = queries[one].start.data();
    segments[pair + 4] = queries[2 * pair + 1 < count ? one + 1 : one].start.data();
  }
  const Vector3d& origin = memory_.surroundings.origin();
  const std::array<double, 4> from = {origin.x(), origin.y(), origin.z(), 0};
  Packet& packet = packets_[static_cast<size_t>(count_)];
  if (!kernels_.pack(segments.data(), static_cast<int>(count), from.data(), kBoxMargin,
                     packet.segments)) {
    return Answer::kAlone;
  }
  if (!memory_.surroundings.Covers(packet.segments)) return Answer::kUncovered;
  if (!memory_.surroundings.usable()) return Answer::kAlone;
  packet.first_query = static_cast<int>(first);
  packet.begun = 0;
  ++count_;
  return Answer::kAdded;
}

void PacketBatch::Run() {
  if (count_ == 0) return;  // the surroundings may never have been gathered
  NearBox* const found = memory_.surroundings.found();
  int boxes = 0;
  for (int i = 0; i < count_; ++i) {
    if (boxes > Surroundings::kMaxBlocks) {
      Test({found, static_cast<size_t>(boxes)});
      boxes = 0;
    }
    boxes += FindBoxes(i, found + boxes);
  }
  Test({found, static_cast<size_t>(boxes)});
  for (int i = 0; i < count_; ++i) {
    const Packet& packet = packets_[static_cast<size_t>(i)];
    for (uint32_t begun = packet.begun; begun != 0; begun &= begun - 1) {
      const auto segment = static_cast<size_t>(__builtin_ctz(begun));
      const TriangleChoice& choice = packet.choices[segment];
      if (choice.found()) {
        choice.Answer(tree_, hits_[static_cast<size_t>(packet.first_query) + segment]);
      }
    }
  }
  count_ = 0;
}

/// Those of the classes that the packet looks for.
int PacketBatch::FindBoxes(int packet, NearBox* found) {
  const Packet& asking = packets_[static_cast<size_t>(packet)];
  const uint32_t mask = queries_[static_cast<size_t>(asking.first_query)].class_mask;
  int count = 0;
  for (const Surroundings::ClassBoxes& list : memory_.surroundings.classes()) {
    if (!Accepts(mask, list.classes)) continue;
    count += kernels_.overlapping_boxes(list.boxes, asking.segments, packet, found + count);
  }
  memory_.counters.blocks += static_cast<uint64_t>(count);
  return count;
}

void PacketBatch::Test(std::span<const NearBox> boxes) {
  PacketWork& work = memory_.surroundings.work();
  const NearBlock* near = memory_.surroundings.blocks();
  for (size_t first = 0; first < boxes.size(); first += PacketWork::kMostBoxes) {
    const auto some =
        boxes.subspan(first, std::min<size_t>(boxes.size() - first, PacketWork::kMostBoxes));
    const int count = kernels_.test_packets(tree_.blocks.data(), near, some.data(),
                                            static_cast<int>(some.size()), &packets_[0].segments,
                                            sizeof(Packet), work, memory_.counters.candidates);
    for (int i = 0; i < count; ++i) {
      const Candidate& candidate = work.candidates[i];
      Offer(some[static_cast<size_t>(candidate.box)], candidate);
    }
  }
}

void PacketBatch::Offer(const NearBox& box, const Candidate& candidate) {
  Packet& packet = packets_[static_cast<size_t>(box.packet)];
  const auto block = static_cast<size_t>(memory_.surroundings.blocks()[box.index].block);
  for (auto bits = static_cast<uint32_t>(candidate.places); bits != 0; bits &= bits - 1) {
    const int segment = SegmentPacket::SegmentAt(__builtin_ctz(bits));
    const int query = packet.first_query + segment;
    TriangleChoice& choice = packet.choices[static_cast<size_t>(segment)];
    if ((packet.begun >> segment & 1) == 0) choice.Begin(queries_[static_cast<size_t>(query)]);
    packet.begun |= 1u << segment;
    choice.Offer(tree_, block, candidate.triangle, query, memory_);
  }
}

}  // namespace eod::sim
