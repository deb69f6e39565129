#pragma once

#include <unordered_map>

#include "sim/segments/split.h"

namespace eod::sim {

/// Turns neighbours into blocks: float coordinates for culling, corners in double for the exact
/// test, each corner once.
class BlockPacker {
 public:
  BlockPacker(std::span<const CollisionTriangle> triangles, BlockTree& tree)
      : triangles_(triangles), tree_(tree) {}

  void Reserve(size_t blocks);
  /// Returns the index of the new block. `items` are 1..16.
  int32_t Pack(std::span<const Item> items);
  /// Gives back what was reserved too much.
  void Finish();

 private:
  uint32_t SurfaceIndex(const CollisionTriangle& triangle);
  uint8_t VertexIndex(uint32_t first_vertex, const Eigen::Vector3d& corner);
  BlockPlace PlaceOf(std::span<const Item> items) const;

  std::span<const CollisionTriangle> triangles_;
  BlockTree& tree_;
  std::unordered_map<uint64_t, uint32_t> surface_index_;
  uint32_t last_surface_ = 0;
};

}  // namespace eod::sim
