#pragma once

#include "sim/isectors/isector_set.h"
#include "sim/robot/robot_state.h"

namespace eod::sim {

/// Puts the robot on the ground that TRIPOD found under it.
///
/// Three legs: height, pitch and roll of the plane. Two: the height moves by their mean, the
/// attitude stays. One: the height alone. None: it falls freely until a leg finds ground again.
/// Source: 1.3 and "missing legs" of the design.
RobotState StandOn(const GroundFix& ground, const RobotState& state, double dt_s);

}  // namespace eod::sim
