#pragma once

#include "sim/isectors/tripod_reading.h"
#include "sim/robot/robot_state.h"

namespace eod::sim {

/// Puts the robot on the ground that TRIPOD found under it, by NextFooting; the normal that two
/// legs keep is the robot's own up axis. Without a leg it falls freely until one finds ground
/// again.
RobotState StandOn(const GroundFix& ground, const RobotState& state, double dt_s);

}  // namespace eod::sim
