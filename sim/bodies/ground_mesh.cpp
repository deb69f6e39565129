#include "sim/bodies/ground_mesh.h"

#include <cmath>

#include "sim/geometry/object_class.h"
#include "sim/world/bullet_shapes.h"

namespace eod::sim {

namespace {

/// Steeper than 45 degrees.
bool IsWall(const Triangle& corner) {
  const Eigen::Vector3d n = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  return std::abs(n.z()) < n.head<2>().norm();
}

struct AnyTriangle final : btTriangleCallback {
  bool found = false;
  void processTriangle(btVector3* /*corners*/, int /*part*/, int /*index*/) override {
    found = true;
  }
};

}  // namespace

GroundMesh::GroundMesh(std::span<const CollisionTriangle> triangles, Kind kind) {
  for (const CollisionTriangle& triangle : triangles) {
    // The ramps that stand for stairs are no surface that a thing could lie on.
    if ((triangle.class_mask & kBumpProxy) == 0) continue;
    if (IsWall(triangle.corner) != (kind == Kind::kWalls)) continue;
    const auto& [a, b, c] = triangle.corner;
    mesh_.addTriangle(ToBullet(a), ToBullet(b), ToBullet(c));
  }
  if (mesh_.getNumTriangles() == 0) return;
  // Not quantised: boxes on a 16-bit grid of a module would be 2 mm too large.
  shape_ = std::make_unique<btBvhTriangleMeshShape>(&mesh_, false);
  shape_->setMargin(0);
}

bool GroundMesh::IsNear(const Eigen::AlignedBox3d& box) const {
  if (shape_ == nullptr) return false;
  AnyTriangle any;
  shape_->processAllTriangles(&any, ToBullet(Eigen::Vector3d(box.min())),
                              ToBullet(Eigen::Vector3d(box.max())));
  return any.found;
}

}  // namespace eod::sim
