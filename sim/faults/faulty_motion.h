#pragma once

#include "sim/faults/active_faults.h"
#include "sim/motion/motion.h"

namespace eod::sim {

/// What broken joints and tracks make of the motions of a step: a stuck joint does not move, a slow
/// one less, a drifting one by itself; a robot with a weak track is slower and pulls to that side,
/// for v = (vl + vr) / 2 and w = (vr - vl) / track. Unchanged where nothing is broken.
MotionDemand FaultyMotion(const RobotModel& robot, const ActiveFaults& faults,
                          const MotionDemand& moving);

}  // namespace eod::sim
