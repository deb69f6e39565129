#pragma once

#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "sim/robot/robot_model.h"

namespace eod::sim {

/// A spot light that is on, in the module's local frame.
struct ShiningSpot {
  Eigen::Vector3f p_M = Eigen::Vector3f::Zero();
  Eigen::Vector3f direction = Eigen::Vector3f::UnitY();  ///< unit
  LampLight light;
  float bright_cosine = 1;  ///< of the angle from the axis to where it begins to fade ...
  float dark_cosine = 0;    ///< ... and to where it is dark
};

/// The shader works with so many at a time.
inline constexpr size_t kMaxSpots = 3;

/// Which of the robot's lamps to draw a picture of the camera at `X_MC` with: of those that are on,
/// the kMaxSpots whose light it sees best, which are those beside it that shine its way. `X_ML`:
/// poses of the robot's links.
std::vector<ShiningSpot> ChooseSpots(const RobotModel& robot, const RobotLights& lights,
                                     std::span<const Eigen::Isometry3d> X_ML,
                                     const Eigen::Isometry3d& X_MC);

}  // namespace eod::sim
