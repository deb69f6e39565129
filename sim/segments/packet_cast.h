#pragma once

#include <array>
#include <span>

#include "sim/segments/kernels.h"
#include "sim/segments/triangle_choice.h"

namespace eod::sim {

/// Up to eight short segments of one group on their way through the blocks around.
class PacketCast {
 public:
  /// `queries` are 1..8 of one class mask, short; `first_query` is the place of the first one in
  /// the list that is cast. Packed relative to `origin`.
  PacketCast(const Kernels& kernels, std::span<const SegmentQuery> queries, int first_query,
             const Eigen::Vector3d& origin);

  /// Whether all of them are castable, beyond doubt.
  bool valid() const { return valid_; }
  const SegmentPacket& packet() const { return packet_; }

  /// Asks the surroundings, which cover the packet, and answers in `hits`. Only if valid.
  void Run(const BlockTree& tree, CastMemory& memory, std::span<SegmentHit> hits) const;

 private:
  struct Choices {
    std::array<TriangleChoice, 8> of;
    uint32_t begun = 0;  ///< bit by bit: those that something was offered to
  };

  void Test(const BlockTree& tree, std::span<const NearBox> boxes, Choices& choices,
            CastMemory& memory) const;

  const Kernels& kernels_;
  std::span<const SegmentQuery> queries_;
  int first_query_;
  SegmentPacket packet_;
  bool valid_;
};

}  // namespace eod::sim
