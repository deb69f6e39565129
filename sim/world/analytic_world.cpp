#include "sim/world/analytic_world.h"

#include <utility>

#include "sim/segments/hit_choice.h"
#include "sim/world/object_name.h"

namespace eod::sim {

using Eigen::Vector3d;

int AnalyticWorld::NewObject(std::string name) {
  names_.push_back(std::move(name));
  return static_cast<int>(names_.size()) - 1;
}

int AnalyticWorld::AddPlane(std::string name, uint32_t class_mask, const Vector3d& point,
                            const Vector3d& n_M) {
  const int object = NewObject(std::move(name));
  planes_.push_back({object, class_mask, point, n_M});
  return object;
}

int AnalyticWorld::AddBox(std::string name, uint32_t class_mask, const Eigen::Isometry3d& X_MB,
                          const Vector3d& size) {
  return AddShape(std::move(name), class_mask, X_MB, Shape::Box(size));
}

int AnalyticWorld::AddShape(std::string name, uint32_t class_mask, const Eigen::Isometry3d& X_MO,
                            Shape shape) {
  const int object = NewObject(std::move(name));
  shapes_.Add(object, class_mask, std::move(shape), X_MO);
  return object;
}

bool AnalyticWorld::Move(int object, const Eigen::Isometry3d& X_MO) {
  return shapes_.Move(object, X_MO);
}

void AnalyticWorld::MeetPlanes(size_t index, const SegmentQuery& query, SegmentHit& best,
                               CastMemory& memory) const {
  for (const Plane& plane : planes_) {
    if (!Accepts(query.class_mask, plane.class_mask)) continue;
    ++memory.counters.candidates;
    const double slope = query.direction.dot(plane.normal);
    if (slope == 0 || (slope > 0 && query.face_rule == FaceRule::kFrontOnly)) continue;
    const double height = (query.start - plane.point).dot(plane.normal);
    const std::optional<double> range = OnSegment(-height / slope, query.length);
    if (!range) continue;
    Offer(static_cast<int>(index), query,
          {.hit = true,
           .point = query.start + *range * query.direction,
           .normal = plane.normal,
           .range = *range,
           .object = plane.object,
           .object_class = plane.class_mask},
          best, memory);
  }
}

void AnalyticWorld::Cast(std::span<const SegmentQuery> queries, std::span<SegmentHit> hits,
                         CastMemory& memory) const {
  memory.counters.segments += queries.size();
  memory.all.clear();
  for (size_t i = 0; i < queries.size(); ++i) {
    hits[i] = SegmentHit{};
    if (IsCastable(queries[i])) {
      MeetPlanes(i, queries[i], hits[i], memory);
    } else {
      ++memory.counters.rejected;
    }
  }
  shapes_.Cast(queries, hits, memory);
  SortListed(memory);
}

const std::string& AnalyticWorld::ObjectName(int object) const { return NameOf(names_, object); }

}  // namespace eod::sim
