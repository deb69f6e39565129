#include "sim/world/bullet_world.h"

#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <btBulletCollisionCommon.h>

#include "sim/segments/hit_choice.h"
#include "sim/world/bullet_shapes.h"
#include "sim/world/object_name.h"

namespace eod::sim {

using Eigen::Vector3d;

namespace {

/// What Bullet holds: the triangles of one object and class, or one shape.
struct Part {
  int object;
  uint32_t class_mask;
  std::vector<int> triangles;  // numbers in the module; none for a shape
  std::unique_ptr<btTriangleMesh> mesh;
  BulletShapePointer shape;
  std::unique_ptr<btCollisionObject> body;
};

/// Takes what one ray meets, and judges it as the other worlds do.
class RayAnswer final : public btCollisionWorld::RayResultCallback {
 public:
  RayAnswer(const std::vector<Part>& parts, int index, const SegmentQuery& query, SegmentHit& best,
            CastMemory& memory)
      : parts_(parts), index_(index), query_(query), best_(best), memory_(memory) {
    m_flags = btTriangleRaycastCallback::kF_KeepUnflippedNormal;
    if (query.face_rule == FaceRule::kFrontOnly)
      m_flags |= btTriangleRaycastCallback::kF_FilterBackfaces;
  }

  bool needsCollision(btBroadphaseProxy* proxy) const override {
    const Part& part = PartOf(static_cast<const btCollisionObject*>(proxy->m_clientObject));
    if (!Accepts(query_.class_mask, part.class_mask)) return false;
    ++memory_.counters.candidates;
    return true;
  }

  btScalar addSingleResult(btCollisionWorld::LocalRayResult& result, bool) override {
    const Part& part = PartOf(result.m_collisionObject);
    const double range = result.m_hitFraction * query_.length;
    const auto* const info = result.m_localShapeInfo;
    const int triangle =
        info == nullptr ? -1 : part.triangles[static_cast<size_t>(info->m_triangleIndex)];
    Offer(index_, query_,
          {.hit = true,
           .point = query_.start + range * query_.direction,
           .normal = FromBullet(result.m_hitNormalLocal),
           .range = range,
           .object = part.object,
           .object_class = part.class_mask,
           .triangle = triangle},
          best_, memory_);
    // Only the nearest hit lets Bullet forget what lies behind it.
    if (query_.hit_rule == HitRule::kNearest) m_closestHitFraction = result.m_hitFraction;
    return m_closestHitFraction;
  }

 private:
  const Part& PartOf(const btCollisionObject* body) const {
    return parts_[static_cast<size_t>(body->getUserIndex())];
  }

  const std::vector<Part>& parts_;
  int index_;
  const SegmentQuery& query_;
  SegmentHit& best_;
  CastMemory& memory_;
};

}  // namespace

struct BulletWorld::Impl {
  BulletOptions options;
  std::vector<std::string> names;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  // The world knows the bodies of the parts; it must go first.
  std::vector<Part> parts;
  btCollisionWorld world{&dispatcher, &broadphase, &configuration};
  std::mutex one_ray_at_a_time;

  void Add(Part part, const Eigen::Isometry3d& X_MO) {
    part.body = std::make_unique<btCollisionObject>();
    part.body->setCollisionShape(part.shape.get());
    part.body->setWorldTransform(ToBullet(X_MO));
    part.body->setUserIndex(static_cast<int>(parts.size()));
    parts.push_back(std::move(part));
    world.addCollisionObject(parts.back().body.get());
  }

  void AddTriangles(const ModuleModel& module) {
    std::map<std::pair<int, uint32_t>, std::vector<int>> groups;
    for (size_t i = 0; i < module.triangles.size(); ++i) {
      const CollisionTriangle& triangle = module.triangles[i];
      groups[{triangle.object, triangle.class_mask}].push_back(static_cast<int>(i));
    }
    for (auto& [key, triangles] : groups) {
      Part part{key.first, key.second, std::move(triangles), std::make_unique<btTriangleMesh>(),
                nullptr,   nullptr};
      for (const int triangle : part.triangles) {
        const auto& [a, b, c] = module.triangles[static_cast<size_t>(triangle)].corner;
        part.mesh->addTriangle(ToBullet(a), ToBullet(b), ToBullet(c));
      }
      // Not quantised: that would end at 2^21 triangles a part, and in a crash.
      part.shape = std::make_unique<btBvhTriangleMeshShape>(part.mesh.get(), false);
      Add(std::move(part), Eigen::Isometry3d::Identity());
    }
  }
};

BulletWorld::BulletWorld(const ModuleModel& module, const BulletOptions& options)
    : impl_(std::make_unique<Impl>()) {
  impl_->options = options;
  for (const WorldObject& object : module.objects) impl_->names.push_back(object.name);
  impl_->AddTriangles(module);
}

BulletWorld::~BulletWorld() = default;

int BulletWorld::AddShape(std::string name, uint32_t class_mask, const Eigen::Isometry3d& X_MO,
                          const Shape& shape) {
  const int object = static_cast<int>(impl_->names.size());
  impl_->names.push_back(std::move(name));
  BulletShapePointer bullet_shape = std::visit(BulletShapeOf{impl_->options.margin}, shape.solid());
  impl_->Add({object, class_mask, {}, nullptr, std::move(bullet_shape), nullptr}, X_MO);
  return object;
}

bool BulletWorld::Move(int object, const Eigen::Isometry3d& X_MO) {
  for (const Part& part : impl_->parts) {
    if (part.object != object || part.mesh) continue;
    part.body->setWorldTransform(ToBullet(X_MO));
    impl_->world.updateSingleAabb(part.body.get());
    return true;
  }
  return false;
}

void BulletWorld::Cast(std::span<const SegmentQuery> queries, std::span<SegmentHit> hits,
                       CastMemory& memory) const {
  const std::scoped_lock lock(impl_->one_ray_at_a_time);
  memory.counters.segments += queries.size();
  memory.all.clear();
  for (size_t i = 0; i < queries.size(); ++i) {
    const SegmentQuery& query = queries[i];
    hits[i] = SegmentHit{};
    if (!IsCastable(query)) ++memory.counters.rejected;
    if (!IsCastable(query) || query.length == 0) continue;  // Bullet divides by the length
    RayAnswer answer(impl_->parts, static_cast<int>(i), query, hits[i], memory);
    if (impl_->options.gjk) answer.m_flags |= btTriangleRaycastCallback::kF_UseGjkConvexCastRaytest;
    impl_->world.rayTest(ToBullet(query.start),
                         ToBullet(Vector3d(query.start + query.length * query.direction)), answer);
  }
  SortListed(memory);
}

const std::string& BulletWorld::ObjectName(int object) const {
  return NameOf(impl_->names, object);
}

}  // namespace eod::sim
