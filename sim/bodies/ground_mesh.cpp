#include "sim/bodies/ground_mesh.h"

#include "sim/geometry/object_class.h"
#include "sim/world/bullet_shapes.h"

namespace eod::sim {

GroundMesh::GroundMesh(std::span<const CollisionTriangle> triangles) {
  for (const CollisionTriangle& triangle : triangles) {
    // The ramps that stand for stairs are no surface that a thing could lie on.
    if ((triangle.class_mask & kBumpProxy) == 0) continue;
    const auto& [a, b, c] = triangle.corner;
    mesh_.addTriangle(ToBullet(a), ToBullet(b), ToBullet(c));
  }
  if (mesh_.getNumTriangles() == 0) return;
  // Not quantised: boxes on a 16-bit grid of a module would be 2 mm too large.
  shape_ = std::make_unique<btBvhTriangleMeshShape>(&mesh_, false);
  shape_->setMargin(0);
}

}  // namespace eod::sim
