#pragma once

#include <algorithm>
#include <numbers>
#include <string>

#include "tests/scenario/operator_script.h"

namespace eod::lockstep {

inline constexpr double kDegree = std::numbers::pi / 180;

/// To y = 6.5 before the station of the lane at x, heading 0.
inline std::string ToLane(double x) {
  std::string text = PowerUp("slope") + DriveAhead(4);
  if (x > 0) text += TurnTo(270, false) + DriveAhead(x) + TurnTo(359.75, true);
  if (x < 0) text += TurnTo(90, true) + DriveAhead(-x) + TurnTo(0.25, false);
  return text + DriveAhead(2.5);
}

/// What a mission came to, for one look at all of it.
struct Extremes {
  double pitch = 0, nose_down = 0, z = 0;  ///< [rad], [m]
  void Watch(LockStepRig& rig) {
    rig.SetStepSink([this](const sim::StepResult& step, const sim::AlarmTable&) {
      pitch = std::max(pitch, step.state.attitude.pitch);
      nose_down = std::min(nose_down, step.state.attitude.pitch);
      z = std::max(z, step.state.position.z());
    });
  }
};

}  // namespace eod::lockstep
