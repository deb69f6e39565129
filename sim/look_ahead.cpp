#include "sim/look_ahead.h"

#include <algorithm>

namespace eod::sim {
namespace {

/// Along `forward_M`, from the module's origin to the foremost guarded point of the robot.
double ForemostPoint(const RobotModel& robot, std::span<const Eigen::Isometry3d> X_ML,
                     const Eigen::Vector3d& forward_M) {
  double foremost = -std::numeric_limits<double>::infinity();
  for (const IsectorSpec& isector : robot.isectors) {
    if (LooksForGround(isector.method)) continue;
    const Eigen::Isometry3d X_MI = X_ML[isector.link] * isector.X_LI;
    for (const SegmentSpec& segment : isector.segments) {
      const Eigen::Vector3d p_I = segment.start + segment.direction * (segment.d0 - segment.skin);
      foremost = std::max(foremost, forward_M.dot(X_MI * p_I));
    }
  }
  return foremost;
}

}  // namespace

Ahead LookAhead(const RobotModel& robot, std::span<const Eigen::Isometry3d> X_ML,
                std::span<const CastSegment> segments) {
  const Eigen::Vector3d forward_M = X_ML[0].linear().col(1);
  Ahead ahead;
  for (const CastSegment& cast : segments) {
    const bool looks_ahead = robot.isectors[cast.isector].method == IsectorMethod::kLos &&
                             cast.query.direction.dot(forward_M) > 0.5;
    if (!looks_ahead || !cast.hit.hit) continue;
    const double clearance = forward_M.dot(cast.hit.point) - ForemostPoint(robot, X_ML, forward_M);
    if (clearance < ahead.clearance) ahead = {.clearance = clearance, .object = cast.hit.object};
  }
  return ahead;
}

}  // namespace eod::sim
