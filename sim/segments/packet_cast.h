#pragma once

#include <span>

#include "sim/segments/kernels.h"
#include "sim/segments/triangle_choice.h"

namespace eod::sim {

/// Up to eight short segments of one group on their way through the blocks around.
class PacketCast {
 public:
  /// `queries` are 1..8 of one class mask; `first_query` is the place of the first one in the list
  /// that is cast. Packed relative to `origin`, which is less than a few dozen metres away.
  PacketCast(std::span<const SegmentQuery> queries, int first_query, const Eigen::Vector3d& origin);

  const SegmentPacket& packet() const { return packet_; }

  /// Asks the surroundings, which cover the packet, and answers in `hits`.
  void Run(const BlockTree& tree, const Kernels& kernels, CastMemory& memory,
           std::span<SegmentHit> hits) const;

 private:
  void Pack(size_t place, const SegmentQuery& query, const Eigen::Vector3d& origin);
  void PackBoxes();
  void Open(const BlockTree& tree, const Kernels& kernels, const Surroundings::Entry& entry,
            std::span<TriangleChoice> choices, CastMemory& memory) const;

  std::span<const SegmentQuery> queries_;
  int first_query_;
  SegmentPacket packet_;
};

}  // namespace eod::sim
