#include "sim/sight.h"

#include <cmath>

namespace eod::sim {
namespace {

constexpr double kSurface = 0.02;  // [m] a point on a surface is not hidden by that

/// In the camera's frame: along +Y, X right, Z up.
bool IsInPicture(const CameraSpec& camera, const Eigen::Vector3d& p_C) {
  if (p_C.y() < camera.near) return false;
  const double half_width = std::tan(camera.horizontal_fov / 2) * p_C.y();
  const double half_height = half_width * camera.height / camera.width;
  return std::abs(p_C.x()) <= half_width && std::abs(p_C.z()) <= half_height;
}

}  // namespace

bool Sees(const CameraSpec& camera, std::span<const Eigen::Isometry3d> X_ML, const World& world,
          const Sight& sight, CastMemory& memory) {
  const Eigen::Isometry3d X_MC = X_ML[static_cast<size_t>(camera.link)] * camera.X_LC;
  const Eigen::Vector3d way = sight.p_M - X_MC.translation();
  const double distance = way.norm();
  if (distance > sight.distance || !IsInPicture(camera, X_MC.inverse() * sight.p_M)) return false;
  SegmentQuery query;
  query.start = X_MC.translation();
  query.direction = way / distance;
  query.length = distance;
  query.class_mask = kAnyModule | kBumpProxy;  // what is solid, not what only carries
  SegmentHit hit;
  world.Cast({&query, 1}, {&hit, 1}, memory);
  if (!hit.hit || hit.range >= distance - kSurface) return true;
  return !sight.object.empty() && world.ObjectName(hit.object) == sight.object;
}

}  // namespace eod::sim
