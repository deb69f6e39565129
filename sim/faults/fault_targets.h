#pragma once

#include "sim/robot/robot_model.h"
#include "sim/scenario/scenario.h"

namespace eod::sim {

/// Index of what a fault is about: a camera of the robot, a joint 0..8, a track (0 left, 1 right),
/// a motion 0..21, a lamp of the box 0..13; -1 for a kind that has no target. Throws
/// std::runtime_error "FILE:LINE: …" as FaultInjector does.
int FindFaultTarget(const FaultSpec& spec, const Scenario& scenario, const RobotModel& robot);

}  // namespace eod::sim
