#pragma once

#include <Eigen/Core>

#include "sim/robot/robot_model.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// A small robot: chassis with a "drive" camera 0.4 m above the ground that looks ahead, a pan and
/// tilt head with a "mast" camera 1.2 m high, and a boom that stands in the drive camera's view.
RobotModel FixtureRobot();

/// Box on the ground: `size` across X, Y, Z, its middle at (x, y).
WorldObject GroundBox(const std::string& name, double x, double y, const Eigen::Vector3d& size,
                      const Material& material);

/// Module 1: 40 x 40 m of grass and a concrete yard. A brick wall 0.3 m thick, 6 m wide and 2.5 m
/// high stands with its face at y = 6.
WorldModel FixtureWorld();

/// Home state at (x, y), heading [rad] counter-clockwise from +Y.
RobotState StandingAt(double x, double y, double heading = 0);

}  // namespace eod::sim
