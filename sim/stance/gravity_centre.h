#pragma once

#include <span>

#include <Eigen/Geometry>

#include "sim/robot/robot_model.h"

namespace eod::sim {

/// What the gripper holds.
struct Load {
  double mass = 0;                                ///< [kg]
  Eigen::Vector3d p_M = Eigen::Vector3d::Zero();  ///< its centre of mass, as X_ML is given
};

/// Centre of gravity of all links and the load, in the frame of the link poses `X_ML`. The links
/// must have mass.
Eigen::Vector3d CentreOfGravity(const RobotModel& robot, std::span<const Eigen::Isometry3d> X_ML,
                                const Load& load = {});

}  // namespace eod::sim
