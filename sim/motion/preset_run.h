#pragma once

#include "sim/motion/motion.h"

namespace eod::sim {

/// Takes the joints to a preset pose while the box asks for it. Its joints set out at
/// rates that bring them there together, and slow down before they arrive. The first thing in the
/// way ends the run: nothing moves on until the request is gone and comes anew.
class PresetRun {
 public:
  explicit PresetRun(const RobotModel& robot) : robot_(robot) {}

  /// The motions towards preset `index`, 0 for none, from `state`; empty when it is reached, was
  /// stopped or does not exist.
  MotionDemand Demand(int index, const RobotState& state, double dt_s);

  /// Something stood in the way of the last demand.
  void Stop() { stopped_ = true; }
  /// Motions of the last demand.
  MotionSet moving() const { return moving_; }

 private:
  double RateOf(int joint, double way, double dt_s) const;

  const RobotModel& robot_;
  int index_ = 0;
  bool stopped_ = false;
  MotionSet moving_ = 0;
};

}  // namespace eod::sim
