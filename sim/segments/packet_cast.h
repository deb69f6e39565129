#pragma once

#include <array>
#include <span>

#include "sim/segments/kernels.h"
#include "sim/segments/triangle_choice.h"

namespace eod::sim {

/// Up to eight short segments of one group on their way through the blocks around.
class PacketCast {
 public:
  /// `queries` are 1..8 of one class mask; `first_query` is the place of the first one in the list
  /// that is cast.
  PacketCast(std::span<const SegmentQuery> queries, int first_query);

  const Eigen::AlignedBox3d& box() const { return box_; }  ///< round all segments, grown a little

  /// Asks the surroundings, which cover the box, and answers in `hits`.
  void Run(const BlockTree& tree, const Kernels& kernels, CastMemory& memory,
           std::span<SegmentHit> hits);

 private:
  void Pack(const Eigen::Vector3d& origin);
  void PackPairs();
  void Open(const BlockTree& tree, const Kernels& kernels, const Surroundings::Entry& entry,
            std::span<TriangleChoice> choices, CastMemory& memory) const;

  std::span<const SegmentQuery> queries_;
  int first_query_;
  Eigen::AlignedBox3d box_;
  SegmentPacket packet_;
};

}  // namespace eod::sim
