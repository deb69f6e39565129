#include "recorder/recorder_node.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <stdexcept>

#include <fmt/format.h>

#include "eod/alarm_t.hpp"
#include "eod/box_command_t.hpp"
#include "eod/image_t.hpp"
#include "eod/link_status_t.hpp"
#include "eod/mission_status_t.hpp"
#include "eod/panel_status_t.hpp"
#include "eod/robot_state_t.hpp"

#include "lcmtypes/channels.h"
#include "platform/terminal.h"
#include "recorder/contact_sheet.h"
#include "recorder/image_codec.h"

namespace eod::recorder {
namespace {

// What still arrives after the end belongs to the run: the last frames and pictures.
constexpr Duration kAftermath = std::chrono::milliseconds(500);

// A burst of states while a picture is written must not be lost.
constexpr int kQueueCapacity = 2000;

constexpr std::array<std::string_view, kCameraCount> kCameraNames{"drive", "mast", "gripper",
                                                                  "rear", "quad"};

template <typename Message>
std::optional<Message> Decode(const lcm::ReceiveBuffer& buffer) {
  Message message;
  if (message.decode(buffer.data, 0, static_cast<int>(buffer.data_size)) < 0) return std::nullopt;
  return message;
}

RobotStateSeen Seen(const robot_state_t& message) {
  RobotStateSeen state;
  state.time = FromUtime(message.utime);
  state.step = message.step;
  state.overruns = message.overruns;
  state.module = std::clamp<int>(message.module, 0, kModuleCount);
  std::ranges::copy(message.position_m, state.position_m.begin());
  state.attitude_deg = {message.heading_deg, message.pitch_deg, message.roll_deg};
  std::ranges::copy(message.joint, state.joint.begin());
  state.speed_mps = message.speed_mps;
  state.inhibit_mask = static_cast<uint32_t>(message.inhibit_mask);
  return state;
}

AlarmSeen Seen(const alarm_t& message) {
  return {FromUtime(message.utime), message.code, message.raised != 0,
          static_cast<uint32_t>(message.parts)};
}

LinkSeen Seen(const link_status_t& message) {
  LinkSeen link;
  link.bus_state = std::clamp<int>(message.bus_state, 0, 2);
  link.quality = message.quality;
  link.rx = message.rx;
  link.tx = message.tx;
  link.lost = message.lost;
  link.crc_errors = message.crc_errors;
  return link;
}

MissionSeen Seen(const mission_status_t& message) {
  const int state = std::clamp<int>(message.state, 0, static_cast<int>(MissionState::kAbort));
  return {static_cast<MissionState>(state), message.module, message.step, message.steps,
          message.step_text};
}

PanelSeen Seen(const panel_status_t& message) {
  return {message.script_line, message.script_done != 0, message.script_failed != 0};
}

}  // namespace

RecorderNode::RecorderNode(const RecorderConfig& config, const RunFolder& folder, CanBus& bus,
                           lcm::LCM& lcm, const Clock& clock)
    : config_(config),
      folder_(folder),
      bus_(bus),
      clock_(clock),
      map_(dbc::LoadControlMap(config.map_file)),
      box_end_(dbc::LoadDatabase(config.dbc_file), map_),
      robot_end_(dbc::LoadDatabase(config.dbc_file), map_),
      typefaces_(LoadTypefaces()),
      log_(folder.lcm_log().string(), "w"),
      load_(config.bit_rate) {
  if (!log_.good()) {
    throw std::runtime_error(fmt::format("{}: cannot be written", folder.lcm_log().string()));
  }
  lcm.subscribe(".*", &RecorderNode::OnMessage, this)->setQueueCapacity(kQueueCapacity);
  started_ = clock_.Now();
  next_line_ = started_;
}

void RecorderNode::OnCan() {
  while (const auto frame = bus_.Receive()) {
    load_.Add(*frame);
    const auto from_box = robot_end_.Decode(*frame, panel_);
    if (from_box.verdict == dbc::FrameVerdict::kAccepted &&
        from_box.role == dbc::BoxMessage::kMotion) {
      observer_.OnMotionFrame(frame->stamp, panel_.motion);
    }
    const auto from_robot = box_end_.Decode(*frame, feedback_);
    if (from_robot.verdict == dbc::FrameVerdict::kAccepted &&
        from_robot.role == dbc::RobotMessage::kAlarm) {
      observer_.OnAlarmFrame(frame->stamp, feedback_.lamp);
    }
  }
}

void RecorderNode::OnMessage(const lcm::ReceiveBuffer* buffer, const std::string& channel) {
  // Frames that wait were there before this message is: keep causes before effects.
  OnCan();
  Observe(*buffer, channel);

  lcm::LogEvent event{};
  event.timestamp = ToUtime(clock_.Now());
  event.channel = channel;
  event.datalen = static_cast<int32_t>(buffer->data_size);
  event.data = buffer->data;
  if (log_.writeEvent(&event) != 0) ++write_failures_;
}

void RecorderNode::Observe(const lcm::ReceiveBuffer& buffer, const std::string& channel) {
  const auto is = [&](const Channel& known) {
    return channel.starts_with(config_.channel_prefix) &&
           channel.size() == config_.channel_prefix.size() + known.name.size() &&
           channel.ends_with(known.name);
  };
  if (is(kRobotStateChannel)) {
    const auto state = Decode<robot_state_t>(buffer);
    if (state) observer_.OnRobotState(clock_.Now(), Seen(*state));
  } else if (is(kBoxCommandChannel)) {
    const auto command = Decode<box_command_t>(buffer);
    if (command) observer_.OnMotionPermitted(command->motion_permitted != 0);
  } else if (is(kAlarmChannel)) {
    const auto alarm = Decode<alarm_t>(buffer);
    if (alarm && alarm->is_repeat == 0) observer_.OnAlarm(Seen(*alarm));
  } else if (is(kLinkStatusChannel)) {
    if (const auto link = Decode<link_status_t>(buffer)) observer_.OnLink(Seen(*link));
  } else if (is(kMissionStatusChannel)) {
    if (const auto mission = Decode<mission_status_t>(buffer)) observer_.OnMission(Seen(*mission));
  } else if (is(kPanelStatusChannel)) {
    const auto panel = Decode<panel_status_t>(buffer);
    if (panel) observer_.OnPanel(Seen(*panel));
  } else if (is(kDriveCameraChannel)) {
    OnImage(buffer, Camera::kDrive);
  } else if (is(kMastCameraChannel)) {
    OnImage(buffer, Camera::kMast);
  } else if (is(kGripperCameraChannel)) {
    OnImage(buffer, Camera::kGripper);
  } else if (is(kRearCameraChannel)) {
    OnImage(buffer, Camera::kRear);
  } else if (is(kQuadCameraChannel)) {
    OnImage(buffer, Camera::kQuad);
  }
}

void RecorderNode::OnImage(const lcm::ReceiveBuffer& buffer, Camera camera) {
  const auto image = Decode<image_t>(buffer);
  if (!image || image->pixelformat != image_t::PIXEL_FORMAT_MJPEG) return;
  const TimePoint time = FromUtime(image->utime);
  observer_.OnPicture(camera, time, image->width, image->height, image->data);
  KeepPicture(camera, time, image->data);
}

void RecorderNode::KeepPicture(Camera camera, TimePoint time, const Jpeg& jpeg) {
  const auto last = kept_.find(camera);
  const size_t alarms = observer_.alarms().size();
  const bool due =
      last == kept_.end() || ToSeconds(time - last->second) >= config_.picture_period_s;
  if (!due && kept_alarms_[camera] == alarms) return;
  kept_[camera] = time;
  kept_alarms_[camera] = alarms;
  try {
    WriteWhole(
        folder_.picture(observer_.SecondsInto(time), kCameraNames[static_cast<size_t>(camera)]),
        jpeg);
  } catch (const std::runtime_error&) {
    ++write_failures_;
  }
}

void RecorderNode::OnTick(TimePoint scheduled) {
  OnCan();
  if (config_.plain) {
    ShowPlain(scheduled);
  } else {
    ShowLine(scheduled);
  }

  const bool reached = (config_.until == Until::kMissionEnd && observer_.mission_ended()) ||
                       (config_.until == Until::kScriptDone && observer_.script_done());
  if (reached && !reached_) reached_ = scheduled;
  const bool expired = config_.seconds > 0 && ToSeconds(scheduled - started_) >= config_.seconds;
  is_finished_ = expired || (reached_ && scheduled - *reached_ >= kAftermath);
}

void RecorderNode::ShowLine(TimePoint) {
  const int columns = TerminalColumns();
  // The last column stays free: a full line would wrap on some terminals.
  const LineStyle style{.columns = std::clamp(columns, 40, 121) - 1, .colour = true};
  std::cout << '\r' << FormatStatusLine(observer_.live(), style) << "\033[K" << std::flush;
}

void RecorderNode::ShowPlain(TimePoint now) {
  const LiveStatus live = observer_.live();
  // News: lamps, mission, inhibited motions and alarms; the rest changes all the time.
  std::string news = fmt::format("{}/{}/{}/{}", static_cast<int>(live.mission.state),
                                 live.mission.step, live.inhibit_mask, observer_.alarms().size());
  for (const auto pattern : live.lamps) news += std::to_string(static_cast<int>(pattern));
  if (news == shown_ && now < next_line_) return;
  shown_ = news;
  next_line_ = now + std::chrono::seconds(1);
  std::cout << FormatStatusLine(live, {.columns = 160, .colour = false}) << std::endl;
}

void RecorderNode::Finish() {
  OnCan();
  if (!config_.plain) std::cout << "\r\033[K";
  Summary summary = observer_.Summarize();
  summary.bus = bus_.url();
  summary.can.bus_load_percent = load_.percent();

  const std::vector<Moment> moments = observer_.TellingMoments(kSheetMoments);
  if (!moments.empty()) {
    WriteWhole(folder_.contact_sheet(), EncodePng(DrawContactSheet(summary, moments, typefaces_)));
  }
  std::fflush(log_.getFilePtr());
  WriteWhole(folder_.summary(), ToJson(summary));
  std::cout << ToText(summary);
  if (observer_.unanswered_presses() > 0) {
    std::cout << fmt::format("note             {} permitted presses moved nothing\n",
                             observer_.unanswered_presses());
  }
  std::cout << fmt::format("files            {}\n", folder_.path().string()) << std::flush;
  if (write_failures_ > 0) {
    throw std::runtime_error(fmt::format("{}: {} writes failed: is the disk full?",
                                         folder_.path().string(), write_failures_));
  }
}

}  // namespace eod::recorder
