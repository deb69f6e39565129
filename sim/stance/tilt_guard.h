#pragma once

#include "sim/robot/robot_model.h"

namespace eod::sim {

/// Refuses the drive motions that would tilt the robot beyond its limits (StanceSpec): one that
/// made the tilt grow out there is refused until the robot is within them again, or its opposite
/// was driven.
class TiltGuard {
 public:
  /// After a step with the drive motions `driven`, which led from `before` to `after`.
  void Update(const StanceSpec& limits, const Attitude& before, const Attitude& after,
              MotionSet driven);
  void Reset() { refused_ = 0; }
  MotionSet refused() const { return refused_; }

 private:
  MotionSet refused_ = 0;
};

}  // namespace eod::sim
