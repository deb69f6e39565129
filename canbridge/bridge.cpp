#include "canbridge/bridge.h"

#include <algorithm>
#include <array>

#include "canbridge/command.h"

namespace eod::bridge {
namespace {

using dbc::BoxMessage;
using dbc::FrameVerdict;
using dbc::RobotMessage;

constexpr std::size_t kMaxFramesPerCall = 32;

TransmitSchedule::CycleTimes RobotCycleTimes(const dbc::BoxCodec& codec) {
  TransmitSchedule::CycleTimes times{};
  for (std::size_t i = 0; i < times.size(); ++i) {
    times[i] = codec.cycle_time(static_cast<RobotMessage>(i));
  }
  return times;
}

// The link is measured by the two messages that motion needs.
bool IsMetered(BoxMessage role) {
  return role == BoxMessage::kSafety || role == BoxMessage::kMotion;
}

double MeteredFramesPerSecond(const dbc::BoxCodec& codec) {
  double rate = 0;
  for (const BoxMessage role : {BoxMessage::kSafety, BoxMessage::kMotion}) {
    const Duration cycle_time = codec.cycle_time(role);
    rate += cycle_time > Duration::zero() ? 1 / ToSeconds(cycle_time) : 1.0;
  }
  return rate;
}

}  // namespace

Bridge::Bridge(const BridgeConfig& config, const dbc::Database& database,
               const dbc::ControlMap& map)
    : config_(config),
      codec_(database, map),
      supervision_(map, config.limits),
      alarms_(map),
      schedule_(RobotCycleTimes(codec_), config.change_gap),
      meter_(MeteredFramesPerSecond(codec_)) {
  output_.frames.reserve(kMaxFramesPerCall);
  output_.alarm_changes.reserve(kMaxFramesPerCall);
  output_.active_alarms.reserve(kMaxFramesPerCall);
}

const BridgeOutput& Bridge::OnFrame(TimePoint now, const CanFrame& frame) {
  Begin(now);
  if (frame.error) return output_;
  if (frame.remote) {
    ++rejects_.unknown_id;
    return output_;
  }
  if (codec_.IsRobotId(frame.id, frame.extended)) {
    is_foreign_robot_ = true;
    supervision_.NoteForeignRobot(now_);
    return Finish();
  }
  const dbc::Received<BoxMessage> received = codec_.Decode(frame, panel_);
  if (!received.role) {
    ++rejects_.unknown_id;
    return output_;
  }
  TakeBoxFrame(received);
  return Finish();
}

void Bridge::TakeBoxFrame(const dbc::Received<BoxMessage>& received) {
  const BoxMessage role = *received.role;
  if (received.verdict == FrameVerdict::kAccepted) {
    if (IsMetered(role)) meter_.Count(now_);
    if (role == BoxMessage::kPanel) TakePanel();
    if (role == BoxMessage::kFire) last_fire_ = now_;
    is_fire_doubtful_ = is_fire_doubtful_ && role != BoxMessage::kFire;
    supervision_.Accept(now_, role, panel_);
    return;
  }
  // A fire frame that is wrong in any way makes the one before it doubtful too.
  is_fire_doubtful_ = is_fire_doubtful_ || role == BoxMessage::kFire;
  if (received.verdict == FrameVerdict::kWrongCrc) ++rejects_.crc;
  if (received.verdict == FrameVerdict::kWrongLength) ++rejects_.length;
  if (received.verdict == FrameVerdict::kRepeated ||
      received.verdict == FrameVerdict::kWrongSequence) {
    ++rejects_.counter;
  }
  supervision_.Reject(now_, role, received.verdict);
}

void Bridge::TakePanel() {
  last_panel_ = now_;
  if (panel_.buzzer_acknowledge && !was_acknowledged_) {
    alarms_.Acknowledge();
    mission_sound_end_.reset();
  }
  was_acknowledged_ = panel_.buzzer_acknowledge;
}

const BridgeOutput& Bridge::OnRobotState(TimePoint now, const RobotReport& robot) {
  Begin(now);
  robot_ = robot;
  supervision_.NoteSimulator(now_);
  supervision_.NoteRobotStops(now_, {.link = robot.link_latched, .estop = robot.field_estop});
  return Finish();
}

const BridgeOutput& Bridge::OnAlarms(TimePoint now, const AlarmReport& alarms) {
  Begin(now);
  alarms_.SetSimulatorAlarms(alarms.view());
  return Finish();
}

const BridgeOutput& Bridge::OnMission(TimePoint now, const MissionReport& mission) {
  Begin(now);
  const bool has_ended = mission.state != mission_.state && mission.state >= 3;
  if (has_ended) {
    mission_sound_end_ = now_ + config_.mission_sound;
    mission_sound_ =
        mission.state == 3 ? dbc::BuzzerPattern::kSuccess : dbc::BuzzerPattern::kFailure;
  }
  mission_ = mission;
  return Finish();
}

const BridgeOutput& Bridge::Tick(TimePoint now, const BusReport& bus) {
  Begin(now);
  bus_ = bus;
  if (!has_booted_) {
    // CANopen: the first heartbeat of a node that came up says boot-up.
    feedback_.nmt = dbc::NmtState::kBootUp;
    Send(RobotMessage::kHeartbeat);
    has_booted_ = true;
  }
  supervision_.NoteBus(now_, bus.state, bus.counters.restarts);
  const BridgeOutput& output = Finish();
  SendCyclic();
  return output;
}

void Bridge::Begin(TimePoint now) {
  now_ = std::max(now_, now);
  output_.frames.clear();
  output_.command.reset();
  output_.link.reset();
  output_.alarm_changes.clear();
  output_.is_alarm_repeat_due = false;
}

const BridgeOutput& Bridge::Finish() {
  PublishCommand();
  PublishAlarms();
  RefreshFeedback();
  SendChanges();
  PublishLinkStatus();
  return output_;
}

void Bridge::PublishCommand() {
  const bool is_fire_fresh = IsWithin(last_fire_, config_.limits.frame_age) && !is_fire_doubtful_;
  const BoxCommand command =
      ComposeCommand(supervision(), panel_,
                     {.panel = IsWithin(last_panel_, config_.panel_age), .fire = is_fire_fresh});
  if (command == published_command_ && now_ < command_due_) return;
  output_.command = command;
  published_command_ = command;
  command_due_ = now_ + config_.command_period;
}

void Bridge::PublishAlarms() {
  const Supervision& outcome = supervision();
  const std::array<AlarmChange, 3> wanted{AlarmChange{kEstopAlarm, outcome.estop_alarm},
                                          AlarmChange{kBoxFaultAlarm, outcome.box_fault_alarm},
                                          AlarmChange{kLinkAlarm, outcome.link_alarm}};
  for (const AlarmChange& alarm : wanted) {
    const bool is_active = std::ranges::any_of(
        output_.active_alarms,
        [&alarm](const ActiveAlarm& active) { return active.code == alarm.code; });
    if (is_active != alarm.raised) output_.alarm_changes.push_back(alarm);
  }
  if (!output_.alarm_changes.empty()) {
    output_.active_alarms.clear();
    for (const AlarmChange& alarm : wanted) {
      if (alarm.raised) output_.active_alarms.push_back({alarm.code, 0});
    }
    alarms_.SetBridgeAlarms(output_.active_alarms);
  }
  output_.is_alarm_repeat_due = output_.alarm_changes.empty() && now_ >= alarms_due_;
  if (output_.is_alarm_repeat_due || !output_.alarm_changes.empty()) {
    alarms_due_ = now_ + config_.alarm_repeat_period;
  }
}

void Bridge::PublishLinkStatus() {
  const Supervision& outcome = supervision();
  const bool is_news = outcome.state != published_state_ || outcome.refusal != published_refusal_;
  if (!is_news && now_ < link_due_) return;
  published_state_ = outcome.state;
  published_refusal_ = outcome.refusal;
  link_due_ = now_ + config_.link_status_period;

  LinkStatus link;
  link.system_state = outcome.state;
  link.bus = bus_;
  if (const std::optional<Duration> age = supervision_.safety_age(now_)) {
    link.box_frame_age_ms = static_cast<int>(*age / std::chrono::milliseconds(1));
  }
  link.quality = meter_.Quality(now_);
  link.lost = bus_.counters.rx_lost + codec_.lost();
  link.rejects = rejects_;
  link.foreign_robot = is_foreign_robot_;
  link.fault = TextOf(outcome.refusal);
  output_.link = link;
}

void Bridge::RefreshFeedback() {
  const bool is_sounding = mission_sound_end_ && now_ < *mission_sound_end_;
  feedback_ =
      ComposeFeedback({.supervision = supervision(),
                       .alarms = alarms_.display(),
                       .robot = robot_,
                       .mission = mission_,
                       .panel = panel_,
                       .mission_sound = is_sounding ? mission_sound_ : dbc::BuzzerPattern::kOff,
                       .is_link_alive = supervision_.is_link_alive(),
                       .is_simulator_alive = supervision_.is_simulator_alive(),
                       .is_panel_seen = IsWithin(last_panel_, config_.panel_age),
                       .is_fire_key_seen = IsWithin(last_fire_, config_.panel_age)});
  feedback_.nmt = dbc::NmtState::kOperational;
  if (const std::optional<Duration> age = supervision_.safety_age(now_)) {
    feedback_.box_frame_age_s = ToSeconds(*age);
  }
}

void Bridge::SendChanges() {
  if (!has_booted_) return;
  if (DiffersInAlarm(feedback_, sent_alarm_) && schedule_.TakeChange(RobotMessage::kAlarm, now_)) {
    Send(RobotMessage::kAlarm);
  }
  if (DiffersInStatus(feedback_, sent_status_) &&
      schedule_.TakeChange(RobotMessage::kStatus, now_)) {
    Send(RobotMessage::kStatus);
  }
  if (DiffersInFire(feedback_, sent_fire_) && schedule_.TakeChange(RobotMessage::kFire, now_)) {
    Send(RobotMessage::kFire);
  }
  if (EmergencyCode(supervision()) != sent_emergency_ &&
      schedule_.TakeChange(RobotMessage::kEmergency, now_)) {
    Send(RobotMessage::kEmergency);
  }
}

void Bridge::SendCyclic() {
  for (int i = 0; i < dbc::kRobotMessageCount; ++i) {
    const auto role = static_cast<RobotMessage>(i);
    if (schedule_.TakeCyclic(role, now_)) Send(role);
  }
}

void Bridge::Send(RobotMessage role) {
  if (is_foreign_robot_) return;
  if (role == RobotMessage::kStatus) {
    feedback_.link_quality = std::min(meter_.Quality(now_), robot_.link_quality);
    sent_status_ = feedback_;
  }
  if (role == RobotMessage::kAlarm) sent_alarm_ = feedback_;
  if (role == RobotMessage::kFire) sent_fire_ = feedback_;
  if (role == RobotMessage::kEmergency) {
    sent_emergency_ = EmergencyCode(supervision());
    feedback_.error_code = sent_emergency_;
    feedback_.error_register = ErrorRegister(sent_emergency_);
  }
  if (const std::optional<CanFrame> frame = codec_.Encode(role, feedback_)) {
    output_.frames.push_back(*frame);
  }
}

}  // namespace eod::bridge
