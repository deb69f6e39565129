#pragma once

namespace eod::sim {

/// How the way between operator and robot behaves, beside what an exercise says about it.
struct LinkRules {
  double check_period = 0;   ///< [s] between two looks at what stands in the way
  double base_antenna = 0;   ///< [m] above the ground
  double robot_antenna = 0;  ///< [m] above the robot's origin
  double drop_below = 0;     ///< quality under which messages get lost, all of them at 0
  double cable_height = 0;   ///< [m] above the robot's origin; what is lower does not bend it
};

}  // namespace eod::sim
