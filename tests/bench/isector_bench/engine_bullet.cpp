#include <btBulletCollisionCommon.h>

#include "tests/bench/isector_bench/engine.h"

#ifndef BT_USE_DOUBLE_PRECISION
#error "Bullet in single precision misses by metres; link bullet_double."
#endif

namespace eod::bench {

namespace {

btVector3 ToBullet(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }
Eigen::Vector3d FromBullet(const btVector3& p) { return {p.x(), p.y(), p.z()}; }

/// Without the 7 MB of pools for contacts, which rays never touch.
btDefaultCollisionConstructionInfo SmallPools() {
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = 1;
  info.m_defaultMaxCollisionAlgorithmPoolSize = 1;
  return info;
}

/// A triangle mesh in a collision world, double precision, with the quantised tree: the other one
/// takes four times the memory and is as fast on short lines, slower on long ones.
class BulletEngine final : public Engine {
 public:
  explicit BulletEngine(const IndexedMesh& mesh) {
    corners_.reserve(3 * mesh.corners.size());
    for (const Eigen::Vector3d& corner : mesh.corners)
      corners_.insert(corners_.end(), {corner.x(), corner.y(), corner.z()});
    indices_.reserve(3 * mesh.triangles.size());
    for (const auto& corners : mesh.triangles) {
      for (const uint32_t corner : corners) indices_.push_back(static_cast<int>(corner));
    }
    AddParts(mesh.triangles.size());
    shape_ = std::make_unique<btBvhTriangleMeshShape>(&parts_, true);
    object_.setCollisionShape(shape_.get());
    world_.addCollisionObject(&object_);
    world_.updateAabbs();
  }
  ~BulletEngine() override { world_.removeCollisionObject(&object_); }

  void Cast(std::span<const sim::SegmentQuery> lines, std::span<sim::SegmentHit> hits) override {
    for (size_t i = 0; i < lines.size(); ++i) {
      const sim::SegmentQuery& line = lines[i];
      const btVector3 from = ToBullet(line.start);
      const btVector3 to = ToBullet(line.start + line.length * line.direction);
      btCollisionWorld::ClosestRayResultCallback nearest(from, to);
      world_.rayTest(from, to, nearest);
      sim::SegmentHit& hit = hits[i];
      hit.hit = nearest.hasHit();
      if (!hit.hit) continue;
      hit.range = nearest.m_closestHitFraction * line.length;
      hit.point = FromBullet(nearest.m_hitPointWorld);
      hit.normal = FromBullet(nearest.m_hitNormalWorld);
    }
  }

 private:
  /// The quantised tree has 21 bits for the triangle within a part, and crashes beyond them.
  void AddParts(size_t triangles) {
    constexpr size_t kPart = size_t{1} << 20;
    for (size_t first = 0; first < triangles; first += kPart) {
      btIndexedMesh part;
      part.m_numTriangles = static_cast<int>(std::min(kPart, triangles - first));
      part.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(&indices_[3 * first]);
      part.m_triangleIndexStride = 3 * sizeof(int);
      part.m_numVertices = static_cast<int>(corners_.size() / 3);
      part.m_vertexBase = reinterpret_cast<const unsigned char*>(corners_.data());
      part.m_vertexStride = 3 * sizeof(double);
      part.m_vertexType = PHY_DOUBLE;
      parts_.addIndexedMesh(part, PHY_INTEGER);
    }
  }

  std::vector<double> corners_;
  std::vector<int> indices_;
  btTriangleIndexVertexArray parts_;
  std::unique_ptr<btBvhTriangleMeshShape> shape_;
  btCollisionObject object_;
  btDefaultCollisionConfiguration configuration_{SmallPools()};
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_{&dispatcher_, &broadphase_, &configuration_};
};

}  // namespace

std::unique_ptr<Engine> BuildBullet(const Source& source) {
  return std::make_unique<BulletEngine>(source.mesh);
}

}  // namespace eod::bench
