#pragma once

#include "sim/motion/motion.h"

namespace eod::sim {

/// The robot's battery: a voltage source that sinks with its charge, behind a resistance. Pure.
class Battery {
 public:
  /// `robot` must outlive it. Without <eod:battery> it rests full at BatterySpec's voltage for
  /// ever.
  explicit Battery(const RobotModel& robot) : robot_(robot) { Reset(); }

  /// Full.
  void Reset();
  /// A step of these motions; `sag` [V] is missing at its poles.
  void Advance(const MotionDemand& moving, double sag, double dt_s);

  double voltage() const { return voltage_; }  ///< [V] at its poles
  double charge() const { return charge_; }    ///< 0..1
  double current() const { return current_; }  ///< [A]
  /// Whether the operator is to be told.
  bool is_low() const { return is_low_; }

 private:
  const RobotModel& robot_;
  double charge_ = 1;
  double current_ = 0;
  double voltage_ = 0;
  bool is_low_ = false;
};

}  // namespace eod::sim
