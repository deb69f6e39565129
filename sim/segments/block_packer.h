#pragma once

#include <array>
#include <unordered_map>

#include "sim/segments/split.h"

namespace eod::sim {

/// The corners of one block, each once: at most 48, found again by a hash of their bits.
class BlockVertices {
 public:
  explicit BlockVertices(std::vector<Eigen::Vector3d>& vertices)
      : vertices_(vertices), first_(vertices.size()) {}
  /// Place of this corner among those of the block.
  uint8_t IndexOf(const Eigen::Vector3d& corner);

 private:
  static constexpr uint8_t kFree = 0xFF;
  std::vector<Eigen::Vector3d>& vertices_;
  size_t first_;
  std::array<uint8_t, 128> slots_ = [] {
    std::array<uint8_t, 128> slots{};
    slots.fill(kFree);
    return slots;
  }();
};

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
  BlockPlace PlaceOf(std::span<const Item> items) const;

  std::span<const CollisionTriangle> triangles_;
  BlockTree& tree_;
  std::unordered_map<uint64_t, uint32_t> surface_index_;
  uint32_t last_surface_ = 0;
};

}  // namespace eod::sim
