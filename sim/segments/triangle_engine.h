#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "sim/segments/block_tree.h"
#include "sim/segments/cast_memory.h"
#include "sim/segments/kernels.h"

namespace eod::sim {

class PacketBatch;

/// Segments against triangles that stand still.
///
/// Short segments of one isector go as a packet of up to eight through the blocks round the reader;
/// long ones walk the tree from near to far. Both only gather candidates, in float and never too
/// few; each is decided by the exact test in double, so all instruction sets give the same hits.
class TriangleEngine {
 public:
  static constexpr double kShort = 4.0;  ///< [m] longer segments walk the tree

  /// Throws std::invalid_argument for triangles that cannot be met, see BuildBlockTree.
  explicit TriangleEngine(std::span<const CollisionTriangle> triangles,
                          InstructionSet instruction_set = BestInstructionSet());

  /// Other triangles from now on. Not while another thread casts.
  void Rebuild(std::span<const CollisionTriangle> triangles);

  /// Answers every query, lists all hits of kAll ones. Thread-safe, one `memory` a thread.
  void Cast(std::span<const SegmentQuery> queries, std::span<SegmentHit> hits,
            CastMemory& memory) const;

  /// As World has it, for triangles alone.
  std::optional<double> LevelGroundIn(const Eigen::AlignedBox3d& box, uint32_t class_mask,
                                      CastMemory& memory) const;

  const BlockTree& tree() const { return tree_; }

 private:
  void CastAlone(const SegmentQuery& query, size_t index, SegmentHit& hit,
                 CastMemory& memory) const;
  bool CastPacket(std::span<const SegmentQuery> queries, size_t first, size_t end,
                  PacketBatch& batch, CastMemory& memory) const;

  BlockTree tree_;
  const Kernels* kernels_;
  uint64_t revision_;  ///< unlike that of any other tree in this process
};

}  // namespace eod::sim
