#include "sim/isectors/terrain_reading.h"

#include <fmt/format.h>

#include "sim/geometry/pose.h"

namespace eod::sim {

namespace {

double HeightAbove(const SegmentHit& hit, const Isector& isector, int64_t step) {
  return isector.PoseOfCast(step).translation().z() - hit.point.z();
}

/// Attitude of what stands on the polygon, looking along the isector's heading.
Attitude AttitudeOn(const SegmentHit& hit, const Isector& isector, int64_t step) {
  // A two-sided segment can meet the underside of a polygon.
  const Eigen::Vector3d n_M = hit.normal.z() < 0 ? Eigen::Vector3d(-hit.normal) : hit.normal;
  return AttitudeOnPlane(n_M, ToAttitude(isector.PoseOfCast(step).linear()).heading);
}

}  // namespace

std::optional<double> ReadHat(const Isector& hat, int64_t step) {
  hat.RequireMethod(IsectorMethod::kHat);
  const SegmentHit& hit = hat.Hit(0, step);
  if (!hit.hit) return std::nullopt;
  return HeightAbove(hit, hat, step);
}

std::optional<double> ReadZ(const Isector& z, int64_t step) {
  z.RequireMethod(IsectorMethod::kZ);
  const SegmentHit& hit = z.Hit(0, step);
  if (!hit.hit) return std::nullopt;
  return hit.point.z();
}

std::optional<TerrainPose> ReadZpr(const Isector& zpr, int64_t step) {
  zpr.RequireMethod(IsectorMethod::kZpr);
  const SegmentHit& hit = zpr.Hit(0, step);
  if (!hit.hit) return std::nullopt;
  const Attitude attitude = AttitudeOn(hit, zpr, step);
  return TerrainPose{.z = hit.point.z(), .pitch = attitude.pitch, .roll = attitude.roll};
}

std::optional<FollowerPose> ReadXyzpr(const Isector& xyzpr, int64_t step) {
  xyzpr.RequireMethod(IsectorMethod::kXyzpr);
  const SegmentHit& hit = xyzpr.Hit(0, step);
  if (!hit.hit) return std::nullopt;
  const Attitude attitude = AttitudeOn(hit, xyzpr, step);
  return FollowerPose{
      .height = HeightAbove(hit, xyzpr, step), .pitch = attitude.pitch, .roll = attitude.roll};
}

}  // namespace eod::sim
