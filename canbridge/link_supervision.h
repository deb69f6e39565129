#pragma once

#include <array>
#include <optional>

#include "canbridge/frame_watch.h"
#include "canbridge/operator_wish.h"
#include "canbridge/rate_ramp.h"
#include "canbridge/refusal.h"
#include "dbc/box_codec.h"
#include "dbc/control_map.h"
#include "dbc/panel_state.h"
#include "dbc/robot_feedback.h"
#include "platform/can_bus.h"
#include "platform/time.h"

namespace eod::bridge {

/// Time limits of the safety rules. A limit is passed when the time is longer, not when it is
/// equal.
struct SupervisionLimits {
  Duration frame_age = std::chrono::milliseconds(100);           ///< older: ramp to zero, SafeStop
  Duration latch_age = std::chrono::milliseconds(500);           ///< older: latched, needs Reset
  Duration ramp = std::chrono::milliseconds(200);                ///< from SafeStop to zero
  Duration heartbeat_age = std::chrono::milliseconds(600);       ///< older: SafeStop
  Duration estop_contradiction = std::chrono::milliseconds(60);  ///< longer: box fault
  Duration simulator_age = std::chrono::milliseconds(500);       ///< older: no motion, Fault
};

/// What the robot says that it stopped for by itself.
struct RobotStops {
  bool link = false;   ///< it heard no command for too long, and wants a Reset
  bool estop = false;  ///< its own emergency stop is pressed
};

/// What may move now, and why not more.
struct Supervision {
  dbc::SystemState state = dbc::SystemState::kInit;
  bool motion_permitted = false;
  MotionRates rate{};         ///< zero unless permitted or ramping down
  uint32_t inhibit_mask = 0;  ///< bit m-1: motion m is wanted, but refused
  dbc::InhibitReason reason = dbc::InhibitReason::kNone;
  Refusal refusal = Refusal::kNone;
  bool link_alarm = false;
  bool box_fault_alarm = false;
  bool estop_alarm = false;
  int resets = 0;  ///< that were accepted

  bool operator==(const Supervision&) const = default;
};

/// Decides whether the operator's wish may move the robot.
///
/// Motion only while all of these hold: key at Operate; emergency stop A = 1 and B = 0; enabling
/// switch Enabled; safety and motion frames valid and not older than 100 ms; box heartbeat
/// operational and not older than 600 ms; nothing latched; all controls neutral since the last
/// stop; simulator alive; bus up; no other robot on it; no invalid signal. Emergency stop, panic
/// position, a fault of the box or of the link latch, and need Reset, then Start.
///
/// Pure: time comes in with every call and never runs backwards for this object.
class LinkSupervision {
 public:
  /// `map` must outlive this object.
  explicit LinkSupervision(const dbc::ControlMap& map, const SupervisionLimits& limits = {});

  /// A frame was accepted; `panel` holds what it carried.
  void Accept(TimePoint now, dbc::BoxMessage role, const dbc::PanelState& panel);
  /// A frame of a known message was dropped.
  void Reject(TimePoint now, dbc::BoxMessage role, dbc::FrameVerdict verdict);
  /// State of the bus; a restart since the last call counts as a loss.
  void NoteBus(TimePoint now, CanBusState state, uint64_t restarts);
  void NoteSimulator(TimePoint now);
  /// The robot's own stops latch here too: one when it comes, the emergency stop while it is
  /// pressed.
  void NoteRobotStops(TimePoint now, const RobotStops& stops);
  /// Another robot sends on this bus: no motion any more.
  void NoteForeignRobot(TimePoint now);
  /// Time passes: time-outs and ramps.
  void Advance(TimePoint now);

  const Supervision& outcome() const { return outcome_; }
  /// Age of the last accepted safety frame; empty if there never was one.
  std::optional<Duration> safety_age(TimePoint now) const;
  /// True while safety and motion frames come in time.
  bool is_link_alive() const { return is_link_alive_; }
  /// True if a robot state came within the last 500 ms.
  bool is_simulator_alive() const { return !IsSimulatorSilent(); }

 private:
  struct Latches {
    bool estop = false;
    bool estop_contradiction = false;
    bool box_fault = false;
    bool crc = false;
    bool link = false;
    bool robot_link = false;
    bool robot_estop = false;
    bool any() const {
      return estop || estop_contradiction || box_fault || crc || link || robot_link || robot_estop;
    }
  };

  void TakeSafety();
  void TakeMotion();
  void TakeAxes(bool was_fresh);
  void CheckOperatorButtons();
  bool CanReset() const;
  void Reset();

  void CheckTimeouts();
  Refusal FindLoss() const;
  void EnterSafeStop();
  void Evaluate();
  Refusal FindRefusal() const;
  Refusal FindLatched() const;
  Refusal FindNotReady() const;
  bool MayRampDown() const;
  dbc::SystemState FindState(Refusal refusal) const;
  bool IsSimulatorSilent() const;
  FrameWatch& watch(dbc::BoxMessage role) { return watches_[static_cast<std::size_t>(role)]; }
  const FrameWatch& watch(dbc::BoxMessage role) const {
    return watches_[static_cast<std::size_t>(role)];
  }

  const dbc::ControlMap& map_;
  SupervisionLimits limits_;
  TimePoint now_{};
  std::optional<TimePoint> start_;
  std::array<FrameWatch, dbc::kBoxMessageCount> watches_;
  dbc::PanelState panel_;
  OperatorWish wish_;
  Latches latches_;
  RobotStops robot_stops_;
  CanBusState bus_state_ = CanBusState::kUp;
  std::optional<uint64_t> bus_restarts_;
  std::optional<TimePoint> last_simulator_;
  std::optional<TimePoint> contradiction_since_;
  std::optional<dbc::Button> last_reset_;  ///< of the previous safety frame; empty after a loss
  std::optional<dbc::Button> last_start_;
  bool is_foreign_robot_ = false;
  bool is_link_alive_ = false;
  bool is_safe_stop_ = false;
  bool is_start_needed_ = false;
  bool is_neutral_seen_ = false;  ///< since the last stop
  RateRamp ramp_;
  Supervision outcome_;
};

}  // namespace eod::bridge
