#pragma once

#include <limits>
#include <span>

#include <Eigen/Geometry>

#include "sim/isectors/isector_set.h"
#include "sim/robot/robot_model.h"

namespace eod::sim {

/// What stands ahead of the robot.
struct Ahead {
  /// [m] from the foremost point of the robot, along the chassis' forward axis
  double clearance = std::numeric_limits<double>::infinity();
  int object = -1;  ///< for World::ObjectName; -1 if nothing is in range
};

/// Reads the forward LOS line among `segments` (the robot file has it cast always). The foremost
/// point of the robot is the foremost of what its isectors guard: their carriers reach d0 - skin
/// from each line's start. `X_ML` are the link poses to measure from.
Ahead LookAhead(const RobotModel& robot, std::span<const Eigen::Isometry3d> X_ML,
                std::span<const CastSegment> segments);

}  // namespace eod::sim
