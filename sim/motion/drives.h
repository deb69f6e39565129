#pragma once

#include <array>

#include "sim/motion/motion.h"

namespace eod::sim {

/// The motors behind the motions: they take a moment to come up to speed and to stop. One axis for
/// driving, one for turning, one a joint; each speeds up and slows down by the acceleration of the
/// robot file. So a motion that is held for t covers rate * t, its run-out included.
class Drives {
 public:
  /// Axes: 0 drive, 1 turn, 2.. the joints; rates are signed, positive forward, left, growing.
  static constexpr int kAxes = 2 + kJointCount;

  explicit Drives(const RobotModel& robot);

  /// What moves in the coming step, given what is wanted: wanted motions, and those that still run
  /// out. `rate` may be above 1 for as long as it takes to slow down into a lower speed range.
  /// `brakes`: slows down at once, whatever the acceleration.
  MotionDemand Follow(const MotionDemand& wanted, double dt_s, bool brakes = false);

  /// These motions stand still at once: something was in their way, or a limit.
  void Halt(MotionSet motions);
  void HaltAll() { rate_ = {}; }

 private:
  double Rated(int axis, int speed_range) const;

  const RobotModel& robot_;
  std::array<int, kAxes> positive_{};  ///< motion that makes the axis' rate positive
  std::array<double, kAxes> rate_{};   ///< of the rated speed in speed_range_
  int speed_range_ = 1;
};

}  // namespace eod::sim
