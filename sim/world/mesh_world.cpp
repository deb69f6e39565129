#include "sim/world/mesh_world.h"

namespace eod::sim {

namespace {

const std::string kNoName;

}  // namespace

MeshWorld::MeshWorld(const ModuleModel& module)
    : triangles_(module.triangles), tree_(module.triangles) {
  for (const WorldObject& object : module.objects) names_.push_back(object.name);
}

void MeshWorld::Cast(std::span<const SegmentQuery> queries, std::span<SegmentHit> hits,
                     CastMemory& memory) const {
  memory.counters.segments += queries.size();
  for (size_t i = 0; i < queries.size(); ++i)
    hits[i] = Cast(queries[i], memory.counters.candidates);
}

SegmentHit MeshWorld::Cast(const SegmentQuery& query, uint64_t& candidates) const {
  // The highest hit of a line that rises is the nearest one from its far end.
  const bool from_end = query.hit_rule == HitRule::kHighest && query.direction.z() > 0;
  // Turned round, the segment would see the other faces as front ones; those few queries stay
  // two-sided.
  const FaceRule face_rule = from_end ? FaceRule::kTwoSided : query.face_rule;
  const Eigen::Vector3d end = query.start + query.length * query.direction;
  const TriangleTree::Nearest nearest =
      from_end
          ? tree_.Cast(end, -query.direction, query.length, query.class_mask, face_rule, candidates)
          : tree_.Cast(query.start, query.direction, query.length, query.class_mask, face_rule,
                       candidates);
  SegmentHit hit;
  if (nearest.triangle < 0) return hit;
  const CollisionTriangle& triangle = triangles_[static_cast<size_t>(nearest.triangle)];
  const auto& [a, b, c] = triangle.corner;
  hit.hit = true;
  hit.range = from_end ? query.length - nearest.range : nearest.range;
  hit.point = query.start + hit.range * query.direction;
  hit.normal = (b - a).cross(c - a).normalized();
  hit.object = triangle.object;
  hit.object_class = triangle.class_mask;
  hit.triangle = nearest.triangle;
  return hit;
}

const std::string& MeshWorld::ObjectName(int object) const {
  const auto index = static_cast<size_t>(object);
  return object < 0 || index >= names_.size() ? kNoName : names_[index];
}

std::unique_ptr<World> BuildWorld(const ModuleModel& module) {
  return std::make_unique<MeshWorld>(module);
}

}  // namespace eod::sim
