#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "canbridge/bridge.h"
#include "dbc/box_codec.h"
#include "dbc/control_map.h"
#include "dbc/database.h"

namespace eod::bridge {

using std::chrono::milliseconds;

/// A bridge with a control box and a simulator around it, in virtual time of 1 ms steps. The box
/// speaks and listens through the codec, so that every test goes through real frames.
class BridgeRig {
 public:
  explicit BridgeRig(const std::filesystem::path& dbc_file = EOD_DATA_DIR "/dbc/control_box.dbc",
                     const std::filesystem::path& map_file = EOD_DATA_DIR
                     "/dbc/control_box.map.toml")
      : database(dbc::LoadDatabase(dbc_file)),
        map(dbc::LoadControlMap(map_file)),
        box(database, map),
        dut(std::in_place, BridgeConfig{}, database, map) {
    panel.key = dbc::KeySwitch::kOperate;
    panel.nmt = dbc::NmtState::kOperational;
  }

  struct Sent {
    TimePoint time;
    CanFrame frame;
    bool is_cyclic = false;  ///< came out of a tick, not of an event
  };

  /// Lets time pass: simulator, then box, then the bridge's tick, every millisecond.
  void Run(Duration length) {
    for (const TimePoint end = now + length; now < end;) {
      now += milliseconds(1);
      Step();
    }
  }

  /// A robot ready to move. Ends at 300 ms.
  void BringUp() {
    Run(milliseconds(240));
    panel.deadman = dbc::Deadman::kEnabled;
    Run(milliseconds(60));
  }

  void Hold(int motion) { panel.motion.at(static_cast<std::size_t>(motion - 1)) = true; }
  void Release(int motion) { panel.motion.at(static_cast<std::size_t>(motion - 1)) = false; }

  /// One frame of the box, now.
  void SendFromBox(dbc::BoxMessage role) {
    if (const std::optional<CanFrame> frame = box.Encode(role, panel)) Take(*frame);
  }
  void Take(const CanFrame& frame) { Note(dut->OnFrame(now, frame), false); }
  void Report(const RobotReport& report) {
    robot = report;
    Note(dut->OnRobotState(now, robot), false);
  }
  void Report(const MissionReport& report) { Note(dut->OnMission(now, report), false); }
  void Alarm(std::initializer_list<ActiveAlarm> active) {
    AlarmReport report;
    std::ranges::copy(active, report.active.begin());
    report.count = static_cast<int>(active.size());
    Note(dut->OnAlarms(now, report), false);
  }

  /// Frames of `role` since the last `Forget`.
  std::vector<Sent> SentAs(dbc::RobotMessage role) const {
    const uint32_t id = IdOf(role);
    std::vector<Sent> frames;
    std::ranges::copy_if(sent, std::back_inserter(frames),
                         [id](const Sent& each) { return each.frame.id == id; });
    return frames;
  }
  uint32_t IdOf(dbc::RobotMessage role) const {
    static constexpr std::array kNames{"status",  "alarm",     "joint_a",  "joint_b",
                                       "joint_c", "pose",      "battery",  "mission",
                                       "fire",    "heartbeat", "emergency"};
    const std::string name = map.robot_messages.at(kNames[static_cast<std::size_t>(role)]).message;
    return database.FindMessage(name)->id;
  }
  void Forget() {
    sent.clear();
    commands.clear();
    links.clear();
    alarm_changes.clear();
  }

  double forward() const { return commands.empty() ? 0 : commands.back().motion_rate[0]; }
  dbc::LampPattern lamp(dbc::Lamp which) const {
    return shown.lamp[static_cast<std::size_t>(which)];
  }

  dbc::Database database;
  dbc::ControlMap map;
  dbc::BoxCodec box;
  std::optional<Bridge> dut;
  dbc::PanelState panel;
  dbc::RobotFeedback shown;  ///< what the box has received
  RobotReport robot;
  BusReport bus;
  TimePoint now{};
  bool box_runs = true;
  bool simulator_runs = true;
  bool panel_frames = false;  ///< BOX_PANEL every 50 ms
  bool fire_frames = false;   ///< BOX_FIRE every 20 ms

  std::vector<Sent> sent;
  std::vector<BoxCommand> commands;
  std::vector<LinkStatus> links;
  std::vector<AlarmChange> alarm_changes;

 private:
  void Step() {
    const auto is_due = [this](int period_ms) {
      return now.time_since_epoch() % milliseconds(period_ms) == Duration::zero();
    };
    if (simulator_runs && is_due(4)) Note(dut->OnRobotState(now, robot), false);
    if (box_runs) {
      if (is_due(200)) SendFromBox(dbc::BoxMessage::kHeartbeat);
      if (is_due(20)) SendFromBox(dbc::BoxMessage::kSafety);
      if (is_due(20)) SendFromBox(dbc::BoxMessage::kMotion);
      if (is_due(20)) SendFromBox(dbc::BoxMessage::kAxes);
      if (fire_frames && is_due(20)) SendFromBox(dbc::BoxMessage::kFire);
      if (panel_frames && is_due(50)) SendFromBox(dbc::BoxMessage::kPanel);
    }
    Note(dut->Tick(now, bus), true);
  }

  void Note(const BridgeOutput& output, bool is_cyclic) {
    for (const CanFrame& frame : output.frames) {
      sent.push_back({now, frame, is_cyclic});
      box.Decode(frame, shown);
    }
    if (output.command) commands.push_back(*output.command);
    if (output.link) links.push_back(*output.link);
    alarm_changes.insert(alarm_changes.end(), output.alarm_changes.begin(),
                         output.alarm_changes.end());
  }
};

}  // namespace eod::bridge
