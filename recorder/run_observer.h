#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "dbc/robot_feedback.h"
#include "recorder/latency_matcher.h"
#include "recorder/moments.h"
#include "recorder/observations.h"
#include "recorder/picture_rate.h"
#include "recorder/step_watch.h"
#include "recorder/summary.h"

namespace eod::recorder {

/// What the status line shows.
struct LiveStatus {
  double t = 0;  ///< [s] since the first robot state
  LampPatterns lamps{};
  double speed_mps = 0;
  uint32_t inhibit_mask = 0;
  double camera_fps = 0;  ///< of the last second
  std::optional<LinkSeen> link;
  MissionSeen mission;
  std::string script_line;
};

/// Watches one run and draws the conclusions. Pure: no bus, no LCM, no clock, no file inside.
class RunObserver {
 public:
  // From the bus.
  void OnMotionFrame(TimePoint stamp, const LatencyMatcher::Buttons& held);
  void OnAlarmFrame(TimePoint stamp, const LampPatterns& lamps);

  // From LCM.
  void OnMotionPermitted(bool permitted) { latency_.OnMotionPermitted(permitted); }
  void OnRobotState(TimePoint received, const RobotStateSeen& state);
  void OnAlarm(const AlarmSeen& alarm);
  void OnLink(const LinkSeen& link) { link_ = link; }
  void OnMission(const MissionSeen& mission);
  void OnPanel(const PanelSeen& panel);
  void OnPicture(Camera camera, TimePoint time, int width, int height, const Jpeg& jpeg);

  /// [s] from the first robot state to `time`; 0 before it.
  double SecondsInto(TimePoint time) const;

  LiveStatus live() const;
  /// Numbers of the run so far; `bus` and the bus load are the caller's to fill in.
  Summary Summarize() const;
  std::vector<Moment> TellingMoments(size_t count) const { return moments_.Select(count); }

  bool mission_ended() const;
  bool script_done() const { return panel_.script_done; }
  int unanswered_presses() const { return latency_.unanswered_presses(); }
  /// Raised alarms so far, oldest first.
  const std::vector<RaisedAlarm>& alarms() const { return alarms_; }

 private:
  std::string Result() const;
  void MarkMissionProgress(const MissionSeen& next);

  std::optional<TimePoint> start_;
  RobotStateSeen state_;
  StepWatch steps_;
  LatencyMatcher latency_;
  LampPatterns lamps_{};
  std::vector<RaisedAlarm> alarms_;
  std::optional<LinkSeen> link_;
  MissionSeen mission_;
  MissionState last_outcome_ = MissionState::kIdle;
  bool script_seen_ = false;
  PanelSeen panel_;

  Moments moments_;
  std::array<PictureRate, kCameraCount> pictures_;
  TimePoint last_picture_{};
  int frame_width_ = 0;
  int frame_height_ = 0;
};

}  // namespace eod::recorder
