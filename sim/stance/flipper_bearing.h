#pragma once

#include <array>

#include "sim/isectors/isector_set.h"
#include "sim/robot/motion_id.h"
#include "sim/robot/robot_model.h"

namespace eod::sim {

/// Flippers that bear. The first touch of the ground stops a flipper on its way down. Who presses
/// on for StanceSpec::press_on_s makes it bear: the ground stops it no more, and lifts that end of
/// the robot instead, until the flipper has left the ground.
class FlipperBearing {
 public:
  /// Whether a segment that stops the motions `blocks` is one that looks down for them alone, and
  /// has met what stands still.
  static bool StopsOnGround(const RobotModel& robot, const CastSegment& cast, MotionSet blocks);

  /// `pressed`: flipper motions that are commanded, and stopped by the ground.
  void Press(const StanceSpec& stance, MotionSet pressed, double dt_s);
  /// `gaps`: [m] below the front and the rear flippers, as Stance has them.
  void Lift(const StanceSpec& stance, const std::array<double, 2>& gaps);
  void Reset() { *this = {}; }

  /// The downward motions of the flippers that bear.
  MotionSet motions() const;

 private:
  struct End {
    double pressed_s = 0;
    bool bears = false;
  };
  std::array<End, 2> ends_;  ///< front, rear
};

}  // namespace eod::sim
