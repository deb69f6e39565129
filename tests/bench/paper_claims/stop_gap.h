#pragma once

#include <string>
#include <vector>

#include "sim/robot/robot_model.h"

namespace eod::claims {

/// Where the robot stood after many drives towards a wall at one speed. A gap is measured from the
/// foremost point of the small wheels to the wall [m]; below 0 they are in it.
struct StopGap {
  double speed_mps = 0;
  double worst = 0;  ///< the smallest gap of all drives
  double mean = 0;
  double largest = 0;
};

/// One frame time.
struct StopGaps {
  double dt_s = 0;
  double d0 = 0;                    ///< [m] D0 from the wheel's surface: its skin
  double v0_mps = 0;                ///< V0 = D0 / dt
  std::vector<StopGap> fixed, eq2;  ///< D = D0 always; D by Eq. 2
  StopGap below_v0, above_v0;       ///< Eq. 2 on both sides of its jump, at V0 (1 -+ 1e-6)
};

/// Drives `robot`, flippers level, straight at a wall: at each speed `starts` times, from places
/// that lie a step's length apart in all, so that one of them is the worst to a step / starts.
StopGaps MeasureStopGaps(const sim::RobotModel& robot, double dt_s,
                         const std::vector<double>& speeds_mps, int starts);

}  // namespace eod::claims
