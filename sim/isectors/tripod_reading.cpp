#include "sim/isectors/tripod_reading.h"

#include <array>

namespace eod::sim {

using Eigen::Vector3d;

namespace {

/// From the plane of the carrier at this leg, which goes through O square to its up axis.
double OffsetFromOwnPlane(const Vector3d& p_M, const Eigen::Isometry3d& X_MI) {
  const Vector3d up = X_MI.linear().col(2), d = p_M - X_MI.translation();
  const double foot = -(up.x() * d.x() + up.y() * d.y()) / up.z();
  return d.z() - foot;
}

}  // namespace

GroundFix ReadTripod(const Isector& tripod, int64_t step) {
  tripod.RequireMethod(IsectorMethod::kTripod);
  const Eigen::Isometry3d& X_MI = tripod.PoseOfCast(step);
  GroundFix ground;
  std::array<Vector3d, 3> feet;
  double offsets = 0;
  for (int leg = 0; leg < 3; ++leg) {
    if (!tripod.IsFresh(step, leg) || !tripod.Hit(leg, step).hit) continue;
    const Vector3d& foot = tripod.Hit(leg, step).point;
    feet[ground.legs++] = foot;
    offsets += OffsetFromOwnPlane(foot, X_MI);
  }
  if (ground.legs == 0) return ground;
  ground.mean_offset = offsets / ground.legs;
  ground.height = X_MI.translation().z() + ground.mean_offset;
  if (ground.legs < 3) return ground;
  Vector3d n = (feet[1] - feet[0]).cross(feet[2] - feet[0]).normalized();
  if (n.z() < 0) n = -n;
  ground.normal = n;
  const Vector3d d = X_MI.translation() - feet[0];
  ground.height = feet[0].z() - (n.x() * d.x() + n.y() * d.y()) / n.z();
  return ground;
}

Footing NextFooting(const GroundFix& ground, const Footing& last, double heading) {
  Footing next = last;
  next.falling = ground.legs == 0;
  next.attitude.heading = heading;
  if (ground.legs == 3) {
    next.z = ground.height;
    next.attitude = AttitudeOnPlane(ground.normal, heading);
    return next;
  }
  next.z += ground.mean_offset;
  const bool turned = heading != last.attitude.heading;
  if (ground.legs == 2 && turned) {
    next.attitude = AttitudeOnPlane(ToRotation(last.attitude).col(2), heading);
  }
  return next;
}

}  // namespace eod::sim
