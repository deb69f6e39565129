#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "sim/geometry/mesh.h"

namespace eod::sim {

inline constexpr int kBlockSize = 16;    ///< triangles a block
inline constexpr int kFanOut = 8;        ///< children a node
inline constexpr int kMaxWaiting = 512;  ///< nodes that a walk can have before it, at most

/// A triangle that segments can meet, in the module's local frame.
struct CollisionTriangle {
  Triangle corner;          ///< counter-clockwise seen from outside [m]
  uint32_t class_mask = 0;  ///< module bit plus proxy and object bits
  int object = 0;           ///< index for World::ObjectName
};

/// Sixteen triangles, coordinate by coordinate, relative to `BlockPlace::origin`. Unused places
/// repeat the first triangle.
struct alignas(64) Block {
  /// [corner][axis][triangle] [m]
  float corner[3][3][kBlockSize];
};

/// Where a block is, and what is known of all its triangles.
struct BlockPlace {
  Eigen::Vector3d origin;     ///< exact in float
  Eigen::Vector3f half_size;  ///< [m] of the box round the origin, rounded up
  float longest_edge = 0;     ///< [m] rounded up
  uint32_t classes = 0;       ///< class mask of all its triangles
  uint32_t first_vertex = 0;  ///< in BlockTree::vertices
  int count = 0;              ///< triangles, 1..16
};

/// What the exact test needs of a triangle: its corners in double, and whose it is.
struct ExactTriangle {
  int32_t triangle = 0;             ///< as loaded
  uint32_t surface = 0;             ///< in BlockTree::surfaces
  std::array<uint8_t, 3> vertex{};  ///< from BlockPlace::first_vertex on
};

struct Surface {
  uint32_t class_mask = 0;
  int object = 0;
  bool operator==(const Surface&) const = default;
};

/// Up to eight children and their boxes, rounded outwards. `child` >= 0: a node; < 0: block ~child.
/// Unused places have a box that nothing meets.
struct alignas(64) Node {
  float low[3][kFanOut];   ///< [m]
  float high[3][kFanOut];  ///< [m]
  int32_t child[kFanOut];
  uint32_t classes[kFanOut];
};

/// Triangles that stand still, in blocks of sixteen neighbours below a tree of boxes. The float
/// coordinates are for culling only; each hit is decided by the corners in double.
struct BlockTree {
  std::vector<Node> nodes;  ///< the root first; empty without triangles
  std::vector<Block> blocks;
  std::vector<BlockPlace> places;         ///< one a block
  std::vector<ExactTriangle> triangles;   ///< 16 a block
  std::vector<Eigen::Vector3d> vertices;  ///< each corner once a block
  std::vector<Surface> surfaces;
  double reach = 0;  ///< [m] largest coordinate of all, either sign

  size_t Bytes() const;  ///< in use
};

/// Builds the tree by a binned surface-area heuristic; the same triangles always give the same
/// tree. Throws std::invalid_argument if a coordinate is not finite or beyond 1e6 m.
BlockTree BuildBlockTree(std::span<const CollisionTriangle> triangles);

}  // namespace eod::sim
