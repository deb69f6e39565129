#include "sim/disposal/shot.h"

#include <algorithm>
#include <cmath>

#include "sim/disposal/charge.h"
#include "sim/segments/isector_method.h"

namespace eod::sim {

Eigen::Isometry3d BarrelPose(const Eigen::Isometry3d& X_MWrist, const DisrupterRules& rules) {
  return X_MWrist * Eigen::Translation3d(rules.muzzle);
}

std::optional<Shot> ShotFrom(const Eigen::Isometry3d& X_MB, const World& world,
                             const ModuleModel& module, std::span<const BodyState> bodies,
                             std::span<const int> movable_of_object, const DisrupterRules& rules,
                             CastMemory& memory) {
  const SegmentQuery query{.start = X_MB.translation(),
                           .direction = X_MB.linear().col(1).normalized(),
                           .length = rules.reach,
                           .class_mask = module.class_bit | UsualClasses(IsectorMethod::kLos)};
  SegmentHit hit;
  world.Cast({&query, 1}, {&hit, 1}, memory);
  const int body = hit.hit ? MovableOf(movable_of_object, hit.object) : -1;
  if (body < 0 || !module.movables[body].explosive) return {};

  const Eigen::Vector3d to_middle = bodies[body].X_MO.translation() - query.start;
  const double offset = query.direction.cross(to_middle).norm();
  const double angle = std::acos(std::clamp(-hit.normal.dot(query.direction), -1.0, 1.0));
  const bool in_range = hit.range >= rules.min_range && hit.range <= rules.max_range;
  return Shot{.body = body,
              .disrupted = in_range && offset <= rules.aim_offset && angle <= rules.aim_angle,
              .p_M = hit.point,
              .impulse_M = rules.impulse * query.direction};
}

}  // namespace eod::sim
