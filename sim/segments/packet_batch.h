#pragma once

#include <array>
#include <span>

#include "sim/segments/kernels.h"
#include "sim/segments/triangle_choice.h"

namespace eod::sim {

/// Short segments of one cast, in packets of up to eight, on their way through the blocks around.
/// They go stage by stage, all packets at once: the work of one does not wait for that of another.
class PacketBatch {
 public:
  static constexpr int kMostPackets = 16;

  /// `queries` and `hits` are those of the whole cast; all must outlive the batch.
  PacketBatch(const BlockTree& tree, const Kernels& kernels, std::span<const SegmentQuery> queries,
              std::span<SegmentHit> hits, CastMemory& memory)
      : tree_(tree), kernels_(kernels), queries_(queries), hits_(hits), memory_(memory) {}

  enum class Answer {
    kAdded,
    kAlone,      ///< each must be cast alone: it may not be castable, or there is too much around
    kUncovered,  ///< not in the surroundings
  };
  /// Adds queries `first` to `end`, 1..8 short ones of one class mask. Runs what is waiting if
  /// there are too many.
  Answer Add(size_t first, size_t end);

  /// Answers all that was added since the last run. Must be called before the surroundings change,
  /// and at the end.
  void Run();

 private:
  /// What waits: a packet, and the choices of those segments that something was offered to.
  struct Packet {
    SegmentPacket segments;
    int first_query;
    uint32_t begun;  ///< bit by bit
    std::array<TriangleChoice, 8> choices;
  };

  int FindBoxes(int packet, NearBox* found);
  void Test(std::span<const NearBox> boxes);
  void Offer(const NearBox& box, const Candidate& candidate);

  const BlockTree& tree_;
  const Kernels& kernels_;
  std::span<const SegmentQuery> queries_;
  std::span<SegmentHit> hits_;
  CastMemory& memory_;
  int count_ = 0;
  std::array<Packet, kMostPackets> packets_;
};

}  // namespace eod::sim
