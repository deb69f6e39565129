#pragma once

#include "sim/robot/robot_model.h"

namespace eod::sim {

/// What the operator does to the lens: numbers of box_command_t.camera_zoom.
enum class ZoomWish : int { kHold, kIn, kOut };

/// The lens of the camera that zooms. It goes at a constant rate of magnification, as a zoom drive
/// does: every second doubles the picture anew.
class ZoomDrive {
 public:
  /// Takes the first camera of the robot that zooms; without one it stays at 1.
  explicit ZoomDrive(const RobotModel& robot, double dt_s);

  /// Magnification against the widest view, 1..most.
  double magnification() const { return magnification_; }
  /// One step. What is no wish holds.
  void Step(ZoomWish wish);
  void Reset() { magnification_ = 1; }

 private:
  double most_ = 1;
  double step_factor_ = 1;
  double magnification_ = 1;
};

}  // namespace eod::sim
