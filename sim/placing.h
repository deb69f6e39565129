#pragma once

#include <span>

#include <Eigen/Geometry>

#include "sim/scenario/scenario.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// Where a robot begins, before it is put down on the ground.
struct StartPose {
  Eigen::Vector3d p_M = Eigen::Vector3d::Zero();
  Attitude attitude;
  bool is_given = false;  ///< by the scenario; else the module's own pad
};

/// The module's start, as the scenario and its repetition move it.
StartPose StartOf(const Scenario& scenario, const ModuleModel& module);

/// X_MO of a movable in this exercise. A heading turns it about the vertical, so that a thing that
/// lies goes on lying.
Eigen::Isometry3d StartOf(const MovableObject& movable, const Placement& place);

/// Throws std::runtime_error "FILE:LINE: …" unless the scenario can be played in `world`: its
/// module is there and has all that the steps name and that is placed, each thing once, and start
/// and places lie within the module's area.
void CheckFits(const Scenario& scenario, const WorldModel& world);

}  // namespace eod::sim
