#include "sim/world/analytic_world.h"

#include <algorithm>
#include <cmath>

namespace eod::sim {

using Eigen::Vector3d;

namespace {

const std::string kNoName;

/// Takes the crossing at `range` if the query's rules prefer it to `best`.
void Offer(const SegmentQuery& query, double range, const Vector3d& normal, int object,
           uint32_t object_class, SegmentHit& best) {
  if (range < -kEndTolerance || range > query.length + kEndTolerance) return;
  if (query.face_rule == FaceRule::kFrontOnly && query.direction.dot(normal) >= 0) return;
  range = std::clamp(range, 0.0, query.length);
  const bool farther_is_better = query.hit_rule == HitRule::kHighest && query.direction.z() > 0;
  const bool better = farther_is_better ? range > best.range : range < best.range;
  if (best.hit && !better) return;
  best = {.hit = true,
          .point = query.start + range * query.direction,
          .normal = normal,
          .range = range,
          .object = object,
          .object_class = object_class};
}

}  // namespace

void AnalyticWorld::AddPlane(std::string name, uint32_t class_mask, const Vector3d& point,
                             const Vector3d& n_M) {
  planes_.push_back({static_cast<int>(names_.size()), class_mask, point, n_M});
  names_.push_back(std::move(name));
}

void AnalyticWorld::AddBox(std::string name, uint32_t class_mask, const Eigen::Isometry3d& X_MB,
                           const Vector3d& size) {
  boxes_.push_back({static_cast<int>(names_.size()), class_mask, X_MB, size / 2});
  names_.push_back(std::move(name));
}

void AnalyticWorld::Meet(const Plane& plane, const SegmentQuery& query, SegmentHit& best) {
  const double closing = query.direction.dot(plane.normal);
  if (closing == 0) return;
  const double range = (plane.point - query.start).dot(plane.normal) / closing;
  Offer(query, range, plane.normal, plane.object, plane.class_mask, best);
}

void AnalyticWorld::Meet(const Box& box, const SegmentQuery& query, SegmentHit& best) {
  const Eigen::Isometry3d X_BM = box.X_MB.inverse();
  const Vector3d start = X_BM * query.start, direction = X_BM.linear() * query.direction;
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0) continue;
    for (const double side : {-1.0, 1.0}) {
      const double range = (side * box.half[axis] - start[axis]) / direction[axis];
      Vector3d at = start + range * direction;
      at[axis] = side * box.half[axis];
      if (((at.cwiseAbs() - box.half).array() > kEndTolerance).any()) continue;
      Offer(query, range, box.X_MB.linear() * (side * Vector3d::Unit(axis)), box.object,
            box.class_mask, best);
    }
  }
}

void AnalyticWorld::Cast(std::span<const SegmentQuery> queries, std::span<SegmentHit> hits,
                         CastMemory& memory) const {
  memory.counters.segments += queries.size();
  const auto offer_all = [&](const auto& shapes, const SegmentQuery& query, SegmentHit& best) {
    for (const auto& shape : shapes) {
      if (!Accepts(query.class_mask, shape.class_mask)) continue;
      ++memory.counters.candidates;
      Meet(shape, query, best);
    }
  };
  for (size_t i = 0; i < queries.size(); ++i) {
    hits[i] = SegmentHit{};
    offer_all(planes_, queries[i], hits[i]);
    offer_all(boxes_, queries[i], hits[i]);
  }
}

const std::string& AnalyticWorld::ObjectName(int object) const {
  const auto index = static_cast<size_t>(object);
  return object < 0 || index >= names_.size() ? kNoName : names_[index];
}

}  // namespace eod::sim
