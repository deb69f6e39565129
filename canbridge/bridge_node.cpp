#include "canbridge/bridge_node.h"

#include <algorithm>

#include <spdlog/spdlog.h>

#include "dbc/database.h"
#include "lcmtypes/channels.h"

namespace eod::bridge {
namespace {

RobotReport ToReport(const robot_state_t& message) {
  RobotReport report;
  report.module = message.module;
  report.heading_deg = message.heading_deg;
  report.pitch_deg = message.pitch_deg;
  report.roll_deg = message.roll_deg;
  report.speed_mps = message.speed_mps;
  std::ranges::copy(message.joint, report.joint.begin());
  report.limit_flags = static_cast<uint16_t>(message.limit_flags);
  report.inhibit_mask = static_cast<uint32_t>(message.inhibit_mask);
  report.inhibit_reason = static_cast<dbc::InhibitReason>(message.inhibit_reason);
  report.grasp_state = message.grasp_state;
  report.fire_state = message.fire_state;
  report.fire_nonce = message.fire_nonce;
  report.circuit_continuity = static_cast<uint8_t>(message.circuit_continuity);
  report.battery_v = message.battery_v;
  report.battery_soc = message.battery_soc;
  report.link_quality = message.link_quality;
  report.link_latched = message.link_latched != 0;
  report.field_estop = message.field_estop != 0;
  report.dark_lamps = static_cast<uint16_t>(message.dark_lamps);
  return report;
}

AlarmReport ToReport(const alarm_t& message) {
  AlarmReport report;
  // The set is gravest first: what does not fit is the least grave.
  report.count = std::clamp<int>(message.num_active, 0, AlarmReport::kCapacity);
  for (std::size_t i = 0; i < static_cast<std::size_t>(report.count); ++i) {
    report.active[i] = {message.active_code[i], static_cast<uint32_t>(message.active_parts[i])};
  }
  return report;
}

MissionReport ToReport(const mission_status_t& message) {
  return {.state = message.state,
          .elapsed_s = message.elapsed_s,
          .score = message.score,
          .step = message.step,
          .steps = message.steps,
          .bomb_state = message.bomb_state,
          .fail_reason = message.fail_reason,
          .collisions = message.collisions};
}

}  // namespace

BridgeNode::BridgeNode(const BridgeNodeConfig& config, CanBus& bus, lcm::LCM& lcm,
                       const Clock& clock)
    : config_(config),
      bus_(bus),
      lcm_(lcm),
      clock_(clock),
      map_(dbc::LoadControlMap(config.map_file)),
      bridge_(config.bridge, dbc::LoadDatabase(config.dbc_file), map_),
      command_channel_(ChannelName(config.channel_prefix, kBoxCommandChannel)),
      link_channel_(ChannelName(config.channel_prefix, kLinkStatusChannel)),
      alarm_channel_(ChannelName(config.channel_prefix, kAlarmChannel)) {
  const std::string robot_channel = ChannelName(config.channel_prefix, kRobotStateChannel);
  const std::string mission_channel = ChannelName(config.channel_prefix, kMissionStatusChannel);
  const auto telemetry = [&config](const Channel& channel) {
    return ChannelName(config.channel_prefix, channel);
  };
  subscriptions_ = {
      lcm_.subscribe(robot_channel, &BridgeNode::OnRobotState, this),
      lcm_.subscribe(alarm_channel_, &BridgeNode::OnAlarm, this),
      lcm_.subscribe(mission_channel, &BridgeNode::OnMission, this),
      lcm_.subscribe(telemetry(kTelemetryStateChannel), &BridgeNode::OnTelemetryState, this),
      lcm_.subscribe(telemetry(kTelemetryAlarmChannel), &BridgeNode::OnTelemetryAlarm, this),
      lcm_.subscribe(telemetry(kTelemetryMissionChannel), &BridgeNode::OnTelemetryMission, this)};
}

BridgeNode::~BridgeNode() {
  for (lcm::Subscription* subscription : subscriptions_) lcm_.unsubscribe(subscription);
}

void BridgeNode::OnCan() {
  while (const std::optional<CanFrame> frame = bus_.Receive()) {
    const TimePoint now = clock_.Now();
    Emit(now, bridge_.OnFrame(now, *frame));
  }
}

void BridgeNode::OnTick(TimePoint scheduled) {
  Emit(scheduled, bridge_.Tick(scheduled, {bus_.state(), bus_.counters()}));
}

// What is relayed reaches the operator by the telemetry channels alone.

void BridgeNode::OnRobotState(const lcm::ReceiveBuffer* buffer, const std::string& channel,
                              const robot_state_t* message) {
  if (message->relayed == 0) OnTelemetryState(buffer, channel, message);
}

void BridgeNode::OnTelemetryState(const lcm::ReceiveBuffer*, const std::string&,
                                  const robot_state_t* message) {
  const TimePoint now = clock_.Now();
  Emit(now, bridge_.OnRobotState(now, ToReport(*message)));
}

void BridgeNode::OnAlarm(const lcm::ReceiveBuffer* buffer, const std::string& channel,
                         const alarm_t* message) {
  // The bridge's own alarms come back on the same channel.
  if (message->source != alarm_t::SOURCE_SIM) return;
  if (message->relayed == 0) OnTelemetryAlarm(buffer, channel, message);
}

void BridgeNode::OnTelemetryAlarm(const lcm::ReceiveBuffer*, const std::string&,
                                  const alarm_t* message) {
  const TimePoint now = clock_.Now();
  Emit(now, bridge_.OnAlarms(now, ToReport(*message)));
}

void BridgeNode::OnMission(const lcm::ReceiveBuffer* buffer, const std::string& channel,
                           const mission_status_t* message) {
  if (message->relayed == 0) OnTelemetryMission(buffer, channel, message);
}

void BridgeNode::OnTelemetryMission(const lcm::ReceiveBuffer*, const std::string&,
                                    const mission_status_t* message) {
  const TimePoint now = clock_.Now();
  Emit(now, bridge_.OnMission(now, ToReport(*message)));
}

void BridgeNode::Emit(TimePoint now, const BridgeOutput& output) {
  // The command first: it is what the operator waits for.
  if (output.command) Publish(now, *output.command);
  for (const CanFrame& frame : output.frames) bus_.Send(frame);
  for (const AlarmChange& change : output.alarm_changes) {
    PublishAlarm(now, &change, output.active_alarms);
  }
  if (output.is_alarm_repeat_due) PublishAlarm(now, nullptr, output.active_alarms);
  if (output.link) Publish(now, *output.link);
  if (bridge_.is_silent() && !was_silent_) {
    spdlog::error("{}: {}", bus_.url(), TextOf(Refusal::kForeignRobot));
    was_silent_ = true;
  }
}

void BridgeNode::Publish(TimePoint now, const BoxCommand& command) {
  box_command_t message{};
  message.utime = ToUtime(now);
  message.sequence = command_sequence_++;
  message.system_state = static_cast<int8_t>(command.system_state);
  message.motion_permitted = command.motion_permitted;
  std::ranges::copy(command.motion_rate, message.motion_rate);
  message.inhibit_mask = static_cast<int32_t>(command.inhibit_mask);
  message.inhibit_reason = static_cast<int8_t>(command.inhibit_reason);
  message.speed_range = static_cast<int8_t>(command.speed_range);
  message.control_mode = static_cast<int8_t>(command.control_mode);
  message.preset = static_cast<int8_t>(command.preset);
  message.arm_key = static_cast<int8_t>(command.fire.arm_key);
  message.fire_left = static_cast<int8_t>(command.fire.fire_left);
  message.fire_right = static_cast<int8_t>(command.fire.fire_right);
  message.circuit = static_cast<int8_t>(command.fire.circuit);
  message.nonce_echo = static_cast<int16_t>(command.fire.nonce_echo);
  message.menu_module = static_cast<int8_t>(command.menu_module);
  message.menu_exercise = static_cast<int8_t>(command.menu_exercise);
  message.menu_command = static_cast<int8_t>(command.menu_command);
  message.camera_select = static_cast<int8_t>(command.camera_select);
  message.camera_zoom = static_cast<int8_t>(command.camera_zoom);
  message.light = static_cast<int8_t>(command.light);
  message.infrared = command.infrared;
  message.horn = command.horn;
  message.lamp_test = command.lamp_test;
  message.buzzer_acknowledge = command.buzzer_acknowledge;
  message.alarm_reset = command.alarm_reset;
  message.resets = command.resets;
  lcm_.publish(command_channel_, &message);
  ++published_;
}

void BridgeNode::Publish(TimePoint now, const LinkStatus& link) {
  const CanBusCounters& counters = link.bus.counters;
  link_status_t message{};
  message.utime = ToUtime(now);
  message.system_state = static_cast<int8_t>(link.system_state);
  message.bus = bus_.url();
  message.bus_state = static_cast<int8_t>(link.bus.state);
  message.box_frame_age_ms = link.box_frame_age_ms;
  message.quality = link.quality;
  message.rx = static_cast<int64_t>(counters.rx);
  message.tx = static_cast<int64_t>(counters.tx);
  message.lost = static_cast<int64_t>(link.lost);
  message.tx_dropped = static_cast<int64_t>(counters.tx_dropped);
  message.crc_errors = link.rejects.crc;
  message.counter_errors = link.rejects.counter;
  message.length_errors = link.rejects.length;
  message.unknown_ids = link.rejects.unknown_id;
  message.error_frames = static_cast<int64_t>(counters.error_frames);
  message.bus_restarts = static_cast<int64_t>(counters.restarts);
  message.foreign_robot = link.foreign_robot;
  message.fault = link.fault;
  lcm_.publish(link_channel_, &message);
  ++published_;
}

void BridgeNode::PublishAlarm(TimePoint now, const AlarmChange* change,
                              const std::vector<ActiveAlarm>& active) {
  alarm_t message{};
  message.utime = ToUtime(now);
  if (change != nullptr) ++alarm_sequence_;
  message.sequence = alarm_sequence_;
  message.source = alarm_t::SOURCE_BRIDGE;
  message.is_repeat = change == nullptr;
  message.code = change != nullptr ? static_cast<int16_t>(change->code) : int16_t{0};
  message.raised = change != nullptr && change->raised;
  message.num_active = static_cast<int16_t>(active.size());
  for (const ActiveAlarm& alarm : active) {
    message.active_code.push_back(static_cast<int16_t>(alarm.code));
    message.active_parts.push_back(static_cast<int32_t>(alarm.parts));
  }
  lcm_.publish(alarm_channel_, &message);
  ++published_;
}

}  // namespace eod::bridge
