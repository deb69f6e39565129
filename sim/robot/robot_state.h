#pragma once

#include <array>

#include <Eigen/Core>

#include "sim/geometry/pose.h"
#include "sim/robot/motion_id.h"

namespace eod::sim {

/// Where the robot is. Positions are in the module's local frame (origin: the module's start pad).
struct RobotState {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< origin, on the ground under the chassis
  Attitude attitude;
  std::array<double, kJointCount> joint{};  ///< [rad]; J7 [m], the mean of both hands
  double left_opening = 0;                  ///< [m] each hand's own opening
  double right_opening = 0;
  double fall_speed = 0;  ///< [m/s] downwards while no support is below
  bool operator==(const RobotState&) const = default;
};

}  // namespace eod::sim
