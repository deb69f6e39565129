#pragma once

#include <chrono>
#include <optional>

#include "canbridge/link_supervision.h"
#include "dbc/control_map.h"

namespace eod::bridge {

using std::chrono::milliseconds;

/// A supervision with a box and a simulator around it, in virtual time of 1 ms steps. The box sends
/// what `panel` says: safety, motion and axes every 20 ms, heartbeat every 200 ms. Parts of it can
/// be made silent.
class SupervisionRig {
 public:
  SupervisionRig() : map(dbc::LoadControlMap(EOD_DATA_DIR "/dbc/control_box.map.toml")), dut(map) {
    panel.key = dbc::KeySwitch::kOperate;
    panel.nmt = dbc::NmtState::kOperational;
    panel.speed_limit = 1;
    panel.joint_rate = 1;
  }

  /// Lets `length` pass; frames that are due come at the beginning of their millisecond.
  void Run(Duration length) {
    for (const TimePoint end = now + length; now < end;) {
      now += milliseconds(1);
      Step();
    }
  }

  /// A robot ready to move: neutral controls for a while, then the enabling switch. Ends at 300 ms.
  void BringUp() {
    Run(milliseconds(240));
    panel.deadman = dbc::Deadman::kEnabled;
    Run(milliseconds(60));
  }

  /// Running forward at full rate since the frames of 320 ms; ends at 340 ms with frames just sent.
  void DriveForward() {
    BringUp();
    Hold(1);
    Run(milliseconds(40));
  }

  void Hold(int motion) { panel.motion.at(static_cast<std::size_t>(motion - 1)) = true; }
  void Release(int motion) { panel.motion.at(static_cast<std::size_t>(motion - 1)) = false; }

  void PressAndRelease(dbc::Button dbc::PanelState::*button) {
    panel.*button = dbc::Button::kPressed;
    Run(milliseconds(40));
    panel.*button = dbc::Button::kReleased;
    Run(milliseconds(40));
  }
  void PressReset() { PressAndRelease(&dbc::PanelState::reset); }
  void PressStart() { PressAndRelease(&dbc::PanelState::start); }

  /// One frame now, out of turn.
  void Send(dbc::BoxMessage role) {
    Transmit(role);
    dut.Accept(now, role, received_);
  }

  const Supervision& outcome() const { return dut.outcome(); }
  bool is_permitted() const { return dut.outcome().motion_permitted; }
  double forward() const { return dut.outcome().rate[0]; }
  bool IsAtRest() const { return dut.outcome().rate == MotionRates{}; }

  dbc::ControlMap map;
  LinkSupervision dut;
  dbc::PanelState panel;
  TimePoint now{};
  bool sends_safety = true;
  bool sends_motion = true;
  bool sends_axes = true;
  bool sends_heartbeat = true;
  bool simulator_runs = true;

 private:
  void Step() {
    const auto is_due = [this](int period_ms) {
      return now.time_since_epoch() % milliseconds(period_ms) == Duration::zero();
    };
    if (simulator_runs && is_due(4)) dut.NoteSimulator(now);
    if (sends_heartbeat && is_due(200)) Send(dbc::BoxMessage::kHeartbeat);
    if (sends_safety && is_due(20)) Send(dbc::BoxMessage::kSafety);
    if (sends_motion && is_due(20)) Send(dbc::BoxMessage::kMotion);
    if (sends_axes && is_due(20)) Send(dbc::BoxMessage::kAxes);
    dut.Advance(now);
  }

  // A frame carries its own signals only.
  void Transmit(dbc::BoxMessage role) {
    const dbc::PanelState before = received_;
    received_ = panel;
    if (role != dbc::BoxMessage::kAxes) received_.axis = before.axis;
    if (role != dbc::BoxMessage::kHeartbeat) received_.nmt = before.nmt;
    if (role != dbc::BoxMessage::kMotion) {
      received_.motion = before.motion;
      received_.button_channel_fault = before.button_channel_fault;
      received_.joint_rate = before.joint_rate;
      received_.preset = before.preset;
    }
    if (role != dbc::BoxMessage::kSafety) {
      received_.key = before.key;
      received_.estop_a = before.estop_a;
      received_.estop_b = before.estop_b;
      received_.deadman = before.deadman;
      received_.reset = before.reset;
      received_.start = before.start;
      received_.mode = before.mode;
      received_.speed_range = before.speed_range;
      received_.speed_limit = before.speed_limit;
      received_.box_fault = before.box_fault;
    }
  }

  dbc::PanelState received_;
};

}  // namespace eod::bridge
