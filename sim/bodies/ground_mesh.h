#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include <Eigen/Geometry>
#include <btBulletDynamicsCommon.h>

#include "sim/segments/block_tree.h"

namespace eod::sim {

/// What stands still, for Bullet: the triangles that things run into, of floors or of walls. Bullet
/// keeps four points of contact with a mesh; a thing that lies on a floor and leans on a wall needs
/// those of both to come to rest.
class GroundMesh {
 public:
  enum class Kind : uint8_t { kFloors, kWalls };
  GroundMesh(std::span<const CollisionTriangle> triangles, Kind kind);
  GroundMesh(const GroundMesh&) = delete;  // the shape knows where the mesh is
  GroundMesh& operator=(const GroundMesh&) = delete;

  /// nullptr without triangles.
  btCollisionShape* shape() { return shape_.get(); }

  /// Whether a triangle may reach into `box`.
  bool IsNear(const Eigen::AlignedBox3d& box) const;

 private:
  btTriangleMesh mesh_;
  std::unique_ptr<btBvhTriangleMeshShape> shape_;
};

}  // namespace eod::sim
