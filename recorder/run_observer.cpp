#include "recorder/run_observer.h"

#include <algorithm>

namespace eod::recorder {
namespace {

constexpr int kEstopAlarm = 0x80;

bool IsOutcome(MissionState state) {
  return state == MissionState::kSuccess || state == MissionState::kFail ||
         state == MissionState::kAbort;
}

}  // namespace

void RunObserver::OnMotionFrame(TimePoint stamp, const LatencyMatcher::Buttons& held) {
  latency_.OnMotionFrame(stamp, held);
}

void RunObserver::OnAlarmFrame(TimePoint stamp, const LampPatterns& lamps) {
  lamps_ = lamps;
  const auto collision = lamps[static_cast<size_t>(dbc::Lamp::kCollision)];
  latency_.OnAlarmFrame(stamp, collision != dbc::LampPattern::kOff);
}

void RunObserver::OnRobotState(TimePoint received, const RobotStateSeen& state) {
  if (!start_) start_ = state.time;
  steps_.Add(state.time, state.step, state.overruns);
  latency_.OnRobotState(received, state);
  state_ = state;
}

void RunObserver::OnAlarm(const AlarmSeen& alarm) {
  const double t = SecondsInto(alarm.time);
  if (alarm.code == kCollisionAlarm) latency_.OnCollisionAlarm(alarm.time, alarm.raised);
  if (alarm.raised) alarms_.push_back({t, alarm.code, alarm.parts});

  // Contact, its end, and an e-stop once the exercise has begun are what a reader wants to see.
  if (alarm.code == kCollisionAlarm && alarm.raised) {
    moments_.MarkWithApproach(t, "Before the contact", "Contact: " + PartNames(alarm.parts));
  } else if (alarm.code == kCollisionAlarm && mission_.state != MissionState::kRun) {
    moments_.Mark(t, "Backed off");
  } else if (alarm.code == kEstopAlarm && alarm.raised && mission_.state >= MissionState::kRun) {
    moments_.Mark(t, "E-stop");
  }
}

void RunObserver::OnMission(const MissionSeen& mission) {
  MarkMissionProgress(mission);
  if (IsOutcome(mission.state)) last_outcome_ = mission.state;
  // A mission that runs again has no outcome yet.
  if (mission.state == MissionState::kRun) last_outcome_ = MissionState::kIdle;
  mission_ = mission;
}

void RunObserver::MarkMissionProgress(const MissionSeen& next) {
  const double t = SecondsInto(state_.time);
  if (next.state == MissionState::kRun && mission_.state != MissionState::kRun) {
    moments_.Mark(t, "Mission starts");
  }
  // The text still describes the step that was just completed.
  if (next.step > mission_.step && mission_.state == MissionState::kRun) {
    moments_.MarkWithApproach(t, mission_.step_text, "\u2713 " + mission_.step_text);
  }
  if (IsOutcome(next.state) && next.state != mission_.state) {
    moments_.Mark(t,
                  next.state == MissionState::kSuccess ? "Mission accomplished" : "Mission failed");
  }
}

void RunObserver::OnPanel(const PanelSeen& panel) {
  script_seen_ = script_seen_ || !panel.script_line.empty() || panel.script_done;
  panel_ = panel;
}

void RunObserver::OnPicture(Camera camera, TimePoint time, int width, int height,
                            const Jpeg& jpeg) {
  moments_.AddPicture(camera, SecondsInto(time), jpeg, lamps_, state_.speed_mps);
  pictures_.at(static_cast<size_t>(camera)).OnPicture(time, last_picture_);
  last_picture_ = time;
  frame_width_ = width;
  frame_height_ = height;
}

double RunObserver::SecondsInto(TimePoint time) const {
  return start_ ? std::max(0.0, ToSeconds(time - *start_)) : 0.0;
}

LiveStatus RunObserver::live() const {
  LiveStatus live;
  live.t = SecondsInto(state_.time);
  live.lamps = lamps_;
  live.speed_mps = state_.speed_mps;
  live.inhibit_mask = state_.inhibit_mask;
  for (const PictureRate& camera : pictures_) {
    live.camera_fps = std::max(live.camera_fps, camera.FpsAt(state_.time));
  }
  live.link = link_;
  live.mission = mission_;
  live.script_line = panel_.script_line;
  return live;
}

bool RunObserver::mission_ended() const { return IsOutcome(last_outcome_); }

std::string RunObserver::Result() const {
  const bool script_pending = script_seen_ && !panel_.script_done;
  if (last_outcome_ == MissionState::kFail || last_outcome_ == MissionState::kAbort ||
      panel_.script_failed) {
    return "fail";
  }
  if (last_outcome_ == MissionState::kSuccess && !script_pending) return "success";
  return "incomplete";
}

Summary RunObserver::Summarize() const {
  Summary summary;
  summary.module = ModuleName(state_.module != 0 ? state_.module : mission_.module);
  summary.result = Result();
  summary.sim_seconds = ToSeconds(steps_.simulated());
  summary.alarms = alarms_;
  if (link_) {
    summary.can.rx = link_->rx;
    summary.can.tx = link_->tx;
    summary.can.lost = link_->lost;
    summary.can.crc_errors = link_->crc_errors;
  }
  const PictureRate& most = *std::ranges::max_element(pictures_, {}, &PictureRate::frames);
  summary.camera.frames = most.frames();
  summary.camera.fps = most.mean_fps();
  summary.camera.width = frame_width_;
  summary.camera.height = frame_height_;
  summary.latency_ms.button_to_pose = ComputePercentiles(latency_.button_to_pose_ms());
  summary.latency_ms.contact_to_lamp_frame = ComputePercentiles(latency_.contact_to_lamp_ms());
  summary.step.period_ms = ToSeconds(steps_.period()) * 1e3;
  summary.step.overruns = steps_.overruns();
  return summary;
}

}  // namespace eod::recorder
