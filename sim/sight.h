#pragma once

#include <span>

#include <Eigen/Geometry>

#include "sim/robot/robot_model.h"
#include "sim/world/world.h"

namespace eod::sim {

/// Something to be looked at, in the module's local frame.
struct Sight {
  Eigen::Vector3d p_M = Eigen::Vector3d::Zero();
  double distance = 0;  ///< [m] at most so far away from the camera
  /// What may hide the point all the same: the object that it belongs to; "" if nothing may.
  std::string_view object;
};

/// Whether the picture of `camera` shows the point, and no solid thing stands between them. Light
/// and air are not asked. `X_ML`: poses of the robot's links.
bool Sees(const CameraSpec& camera, std::span<const Eigen::Isometry3d> X_ML, const World& world,
          const Sight& sight, CastMemory& memory);

}  // namespace eod::sim
