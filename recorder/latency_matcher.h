#pragma once

#include <array>
#include <optional>
#include <vector>

#include "dbc/panel_state.h"
#include "platform/time.h"
#include "recorder/observations.h"

namespace eod::recorder {

/// Measures the two delays that a trainee feels, from what an observer can see.
///
/// button to pose: from the frame on the bus in which a motion button goes from released to held,
/// while that motion is permitted and the robot stands still, to the reception of the first robot
/// state in which the pose or a joint has moved. A press that is given up before the robot moved,
/// or that moves nothing within one second, is no sample; `unanswered_presses` counts the latter.
///
/// contact to lamp frame: from the scheduled time of the step that raised a collision to the first
/// alarm frame on the bus whose collision lamp is not off. A collision that is raised while the
/// lamp is on already is no sample.
class LatencyMatcher {
 public:
  using Buttons = std::array<bool, dbc::kMotionCount>;

  void OnMotionFrame(TimePoint stamp, const Buttons& held);
  void OnMotionPermitted(bool permitted) { permitted_ = permitted; }
  void OnRobotState(TimePoint received, const RobotStateSeen& state);
  void OnCollisionAlarm(TimePoint step_time, bool raised);
  void OnAlarmFrame(TimePoint stamp, bool collision_lamp_on);

  /// Samples in the order they were taken [ms].
  const std::vector<double>& button_to_pose_ms() const { return button_to_pose_ms_; }
  const std::vector<double>& contact_to_lamp_ms() const { return contact_to_lamp_ms_; }
  int unanswered_presses() const { return unanswered_presses_; }

 private:
  struct Press {
    size_t motion = 0;
    TimePoint stamp{};
  };
  void MatchPress(TimePoint received, bool moved);

  Buttons held_{};
  bool buttons_known_ = false;
  bool permitted_ = false;
  bool standing_still_ = false;
  std::optional<RobotStateSeen> last_state_;
  std::optional<Press> press_;
  int unanswered_presses_ = 0;
  std::vector<double> button_to_pose_ms_;

  bool lamp_on_ = false;
  TimePoint lamp_on_since_{};
  std::optional<TimePoint> contact_;
  std::vector<double> contact_to_lamp_ms_;
};

}  // namespace eod::recorder
