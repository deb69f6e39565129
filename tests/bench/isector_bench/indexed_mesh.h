#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/world/world_model.h"

namespace eod::bench {

/// Triangles with shared corners, as the other engines like them best. Corners are one where all
/// bits of their coordinates are.
struct IndexedMesh {
  std::vector<Eigen::Vector3d> corners;            ///< in M
  std::vector<std::array<uint32_t, 3>> triangles;  ///< in the order of the module
  /// Middle of the bounding box: what engines with single precision count from, so that they are
  /// as exact as they can be.
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
};

IndexedMesh MakeIndexed(std::span<const sim::CollisionTriangle> triangles);

}  // namespace eod::bench
