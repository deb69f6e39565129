#pragma once

#include <memory>
#include <span>

#include <btBulletDynamicsCommon.h>

#include "sim/segments/block_tree.h"

namespace eod::sim {

/// What stands still, for Bullet: all triangles that things run into.
class GroundMesh {
 public:
  explicit GroundMesh(std::span<const CollisionTriangle> triangles);

  /// nullptr without triangles.
  btCollisionShape* shape() { return shape_.get(); }

 private:
  btTriangleMesh mesh_;
  std::unique_ptr<btBvhTriangleMeshShape> shape_;
};

}  // namespace eod::sim
