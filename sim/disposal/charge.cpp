#include "sim/disposal/charge.h"

#include <algorithm>
#include <cmath>

namespace eod::sim {

bool IsOnCharge(const ExplosiveSpec& charge, const Eigen::Isometry3d& X_MO,
                const Eigen::Vector3d& p_M, double tolerance) {
  const Eigen::Vector3d p_O = X_MO.inverse() * p_M;
  const double across = std::hypot(p_O.x(), p_O.y()) - charge.radius;
  const double along = std::abs(p_O.z()) - charge.half_height;
  const bool on_mantle = std::abs(across) <= tolerance && along <= tolerance;
  const bool on_cap = std::abs(along) <= tolerance && across <= tolerance;
  return on_mantle || on_cap;
}

double LowestPoint(const ExplosiveSpec& charge, const Eigen::Isometry3d& X_MO) {
  const double upright = std::min(1.0, std::abs(X_MO.linear()(2, 2)));
  return X_MO.translation().z() - charge.half_height * upright -
         charge.radius * std::sqrt(1 - upright * upright);
}

std::vector<int> ChargesOf(const ModuleModel& module) {
  std::vector<int> charges;
  for (size_t i = 0; i < module.movables.size(); ++i) {
    if (module.movables[i].explosive) charges.push_back(static_cast<int>(i));
  }
  return charges;
}

int MovableOf(std::span<const int> movable_of_object, int object) {
  const bool known = object >= 0 && static_cast<size_t>(object) < movable_of_object.size();
  return known ? movable_of_object[static_cast<size_t>(object)] : -1;
}

bool IsWithinWalls(const VesselSpec& vessel, const Eigen::Vector3d& p_V) {
  if (vessel.inner_radius > 0) return std::hypot(p_V.x(), p_V.y()) < vessel.inner_radius;
  return std::abs(p_V.x()) < vessel.half_size.x() && std::abs(p_V.y()) < vessel.half_size.y();
}

bool IsInside(const VesselSpec& vessel, const Eigen::Vector3d& p_M, double lowest_z,
              double net_sag) {
  const Eigen::Vector3d p_V = vessel.X_MV.inverse() * p_M;
  const double lowest = lowest_z - vessel.X_MV.translation().z();
  if (lowest >= vessel.rim_z || lowest < vessel.net_z - net_sag) return false;
  return IsWithinWalls(vessel, p_V);
}

}  // namespace eod::sim
