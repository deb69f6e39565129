#include "tests/bench/isector_bench/indexed_mesh.h"

#include <bit>
#include <limits>

namespace eod::bench {

namespace {

using Eigen::Vector3d;

/// Finds the number of a corner: open addressing in a table that is never full.
class CornerTable {
 public:
  CornerTable(size_t most, std::vector<Vector3d>& corners)
      : slots_(std::bit_ceil(most + 1), kFree), corners_(corners) {}

  uint32_t NumberOf(const Vector3d& corner) {
    for (size_t slot = Hash(corner) & (slots_.size() - 1);;
         slot = (slot + 1) & (slots_.size() - 1)) {
      if (slots_[slot] == kFree) {
        slots_[slot] = static_cast<uint32_t>(corners_.size());
        corners_.push_back(corner);
        return slots_[slot];
      }
      if (corners_[slots_[slot]] == corner) return slots_[slot];
    }
  }

 private:
  static constexpr uint32_t kFree = std::numeric_limits<uint32_t>::max();

  static size_t Hash(const Vector3d& corner) {
    uint64_t hash = 0;
    for (const double value : corner) {
      hash = (hash ^ std::bit_cast<uint64_t>(value)) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 32;
    }
    return hash;
  }

  std::vector<uint32_t> slots_;
  std::vector<Vector3d>& corners_;
};

}  // namespace

IndexedMesh MakeIndexed(std::span<const sim::CollisionTriangle> triangles) {
  IndexedMesh mesh;
  mesh.triangles.reserve(triangles.size());
  CornerTable table(3 * triangles.size(), mesh.corners);
  for (const sim::CollisionTriangle& triangle : triangles) {
    const auto& [a, b, c] = triangle.corner;
    mesh.triangles.push_back({table.NumberOf(a), table.NumberOf(b), table.NumberOf(c)});
  }
  Eigen::AlignedBox3d bounds;
  for (const Vector3d& corner : mesh.corners) bounds.extend(corner);
  mesh.middle = bounds.center();
  return mesh;
}

}  // namespace eod::bench
