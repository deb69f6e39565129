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
  double fall_speed = 0;  ///< [m/s] downwards, of the point that sinks fastest for want of support
  Eigen::Vector2d slip = Eigen::Vector2d::Zero();  ///< [m/s] along the slope, in plan view
  bool at_rest = false;     ///< ground, gravity and friction leave it where it stands
  bool rolls_over = false;  ///< its centre of gravity is beyond all that could carry it
  bool operator==(const RobotState&) const = default;
};

}  // namespace eod::sim
