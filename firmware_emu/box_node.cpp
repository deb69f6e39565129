#include "firmware_emu/box_node.h"

#include <algorithm>
#include <stdexcept>

#include <spdlog/spdlog.h>

#include "dbc/control_map.h"
#include "dbc/database.h"
#include "lcmtypes/channels.h"

namespace eod::box {
namespace {

constexpr Duration kStatusPeriod = std::chrono::milliseconds(100);
constexpr uint64_t kReportedBadActions = 10;

// What a watcher must learn at once; numbers that drift wait for the next period.
bool IsSameAtAGlance(const panel_status_t& a, const panel_status_t& b) {
  return a.box_state == b.box_state && std::equal(a.lamp, a.lamp + dbc::kLampCount, b.lamp) &&
         std::equal(a.lamp_lit, a.lamp_lit + dbc::kLampCount, b.lamp_lit) && a.buzzer == b.buzzer &&
         a.alarm_code == b.alarm_code && a.hit_parts == b.hit_parts &&
         a.inhibit_mask == b.inhibit_mask && a.inhibit_reason == b.inhibit_reason &&
         a.pressed == b.pressed && a.mission_state == b.mission_state &&
         a.script_line == b.script_line && a.script_done == b.script_done;
}

}  // namespace

BoxNode::BoxNode(const BoxNodeConfig& config, CanBus& bus, lcm::LCM& lcm, const Clock& clock)
    : config_(config),
      bus_(bus),
      lcm_(lcm),
      clock_(clock),
      map_(dbc::LoadControlMap(config.map_file)),
      box_(dbc::BoxCodec(dbc::LoadDatabase(config.dbc_file), map_), config.box),
      status_channel_(ChannelName(config.channel_prefix, kPanelStatusChannel)) {
  if (config_.script) {
    runner_.emplace(*config_.script);
    eyes_.emplace(config_.channel_prefix, lcm_, clock_);
  }
  subscription_ = lcm_.subscribe(ChannelName(config_.channel_prefix, kPanelCommandChannel),
                                 &BoxNode::OnPanelCommand, this);
}

BoxNode::~BoxNode() { lcm_.unsubscribe(subscription_); }

std::optional<std::string> BoxNode::script_failure() const {
  return runner_ ? runner_->failure() : std::nullopt;
}

std::string_view BoxNode::alarm_name(int code) const {
  const dbc::AlarmMap* alarm = map_.FindAlarm(code);
  return alarm == nullptr ? std::string_view() : alarm->name;
}

void BoxNode::OnCan() {
  const TimePoint now = clock_.Now();
  while (const std::optional<CanFrame> frame = bus_.Receive()) box_.OnFrame(*frame, now);
}

void BoxNode::OnTick(TimePoint scheduled) {
  if (runner_) runner_->Tick(scheduled, box_.status(), eyes_->sight(), hands_);
  hands_.Tick(scheduled);
  const std::span<const CanFrame> frames = box_.Tick(scheduled, hands_.inputs());
  for (const CanFrame& frame : frames) bus_.Send(frame);
  // The box measures against scheduled time; how late the tick itself came is added here.
  if (!frames.empty()) {
    max_late_ = std::max(max_late_, box_.status().late + (clock_.Now() - scheduled));
  }
  if (config_.tell) TellChanges(scheduled);
  PublishStatus(scheduled);
}

void BoxNode::OnPanelCommand(const lcm::ReceiveBuffer* /*buffer*/, const std::string& /*channel*/,
                             const panel_command_t* command) {
  for (const std::string& action : command->action) {
    try {
      hands_.Apply(ParseAction(action), clock_.Now());
    } catch (const std::runtime_error& error) {
      CountBadAction(error.what());
    }
  }
}

void BoxNode::CountBadAction(const std::string& why) {
  ++bad_actions_;
  if (bad_actions_ > kReportedBadActions) return;
  spdlog::warn("panel command ignored: {}{}", why,
               bad_actions_ == kReportedBadActions ? " (more of these stay unreported)" : "");
}

void BoxNode::TellChanges(TimePoint now) {
  if (runner_) {
    for (const std::string& note : runner_->TakeNotes()) config_.tell(now, "* " + note);
  }
  for (const std::string& line : journal_.Observe(box_.status())) config_.tell(now, line);
  if (is_script_done() && !has_told_end_) {
    config_.tell(now, "script " + (script_failure() ? "failed: " + *script_failure() : "done"));
    has_told_end_ = true;
  }
}

void BoxNode::PublishStatus(TimePoint now) {
  const panel_status_t status = MakeStatus(now);
  if (now < next_status_ && IsSameAtAGlance(status, last_status_)) return;
  lcm_.publish(status_channel_, &status);
  ++published_;
  last_status_ = status;
  next_status_ = now + kStatusPeriod;
}

panel_status_t BoxNode::MakeStatus(TimePoint now) const {
  const PanelStatus& shown = box_.status();
  const dbc::RobotFeedback& robot = shown.feedback;
  panel_status_t status{};
  status.utime = ToUtime(now);
  status.box_state = static_cast<int8_t>(shown.state);
  for (int i = 0; i < dbc::kLampCount; ++i) {
    status.lamp[i] = static_cast<int8_t>(shown.lamp[i]);
    status.lamp_lit[i] = shown.lit[i] ? 1 : 0;
  }
  status.buzzer = static_cast<int8_t>(shown.buzzer);
  status.alarm_code = static_cast<int16_t>(robot.alarm_code);
  status.hit_parts = static_cast<int32_t>(robot.hit_parts);
  status.inhibit_mask = static_cast<int32_t>(robot.inhibit_mask);
  status.inhibit_reason = static_cast<int8_t>(robot.inhibit_reason);
  status.speed_mps = robot.speed_mps;
  status.heading_deg = robot.heading_deg;
  std::copy(robot.joint.begin(), robot.joint.end(), status.joint);
  for (int m = 0; m < dbc::kMotionCount; ++m) {
    if (shown.reported.motion[m]) status.pressed |= 1 << m;
  }
  status.mission_state = static_cast<int8_t>(robot.mission_state);
  status.rx = static_cast<int64_t>(shown.rx);
  status.crc_errors = static_cast<int64_t>(shown.crc_errors);
  status.max_late_us = std::chrono::duration_cast<std::chrono::microseconds>(max_late_).count();
  if (runner_) status.script_line = runner_->current_line();
  status.script_done = is_script_done() ? 1 : 0;
  status.script_failed = script_failure() ? 1 : 0;
  return status;
}

}  // namespace eod::box
