#include "canbridge/link_supervision.h"

#include <algorithm>

namespace eod::bridge {
namespace {

using dbc::BoxMessage;
using dbc::Button;
using dbc::SystemState;

bool IsEdge(const std::optional<Button>& before, Button after) {
  return before == Button::kReleased && after == Button::kPressed;
}

}  // namespace

LinkSupervision::LinkSupervision(const dbc::ControlMap& map, const SupervisionLimits& limits)
    : map_(map), limits_(limits) {}

void LinkSupervision::Accept(TimePoint now, BoxMessage role, const dbc::PanelState& panel) {
  // First what the silence before this frame means, then the frame.
  Advance(now);
  const bool was_fresh = watch(role).IsFresh(limits_.frame_age, now_);
  watch(role).Accept(now_);
  panel_ = panel;
  wish_ = ReadWish(map_, panel_);
  if (role == BoxMessage::kSafety) TakeSafety();
  if (role == BoxMessage::kMotion) TakeMotion();
  if (role == BoxMessage::kAxes) TakeAxes(was_fresh);
  CheckTimeouts();
  Evaluate();
}

void LinkSupervision::Reject(TimePoint now, BoxMessage role, dbc::FrameVerdict verdict) {
  Advance(now);
  switch (verdict) {
    case dbc::FrameVerdict::kWrongCrc:
      watch(role).NoteWrongCrc();
      latches_.crc = latches_.crc || watch(role).HasCrcFault();
      break;
    case dbc::FrameVerdict::kRepeated:
    case dbc::FrameVerdict::kWrongSequence:
      watch(role).NoteGoodCrc();
      break;
    case dbc::FrameVerdict::kAccepted:
    case dbc::FrameVerdict::kUnknownId:
    case dbc::FrameVerdict::kWrongLength:
      break;
  }
  Evaluate();
}

void LinkSupervision::NoteBus(TimePoint now, CanBusState state, uint64_t restarts) {
  bus_state_ = state;
  if (restarts != bus_restarts_.value_or(restarts)) EnterSafeStop();
  bus_restarts_ = restarts;
  Advance(now);
}

void LinkSupervision::NoteSimulator(TimePoint now) {
  Advance(now);
  last_simulator_ = now_;
  Evaluate();
}

void LinkSupervision::NoteRobotStops(TimePoint now, const RobotStops& stops) {
  Advance(now);
  // Told with the link's delay: the latch that a Reset has just cleared must not come back.
  latches_.robot_link = latches_.robot_link || (stops.link && !robot_stops_.link);
  latches_.robot_estop = latches_.robot_estop || stops.estop;
  robot_stops_ = stops;
  Evaluate();
}

void LinkSupervision::NoteForeignRobot(TimePoint now) {
  is_foreign_robot_ = true;
  Advance(now);
}

void LinkSupervision::Advance(TimePoint now) {
  now_ = std::max(now_, now);
  if (!start_) start_ = now_;
  CheckTimeouts();
  Evaluate();
}

std::optional<Duration> LinkSupervision::safety_age(TimePoint now) const {
  const std::optional<TimePoint> last = watch(BoxMessage::kSafety).last();
  if (!last) return std::nullopt;
  return std::max(now - *last, Duration::zero());
}

void LinkSupervision::TakeSafety() {
  if (panel_.estop_a == panel_.estop_b) {
    if (!contradiction_since_) contradiction_since_ = now_;
  } else {
    contradiction_since_.reset();
  }
  const bool is_estop_pressed = !panel_.estop_a && panel_.estop_b;
  if (is_estop_pressed || panel_.deadman == dbc::Deadman::kPanic) latches_.estop = true;
  if (panel_.box_fault != 0) latches_.box_fault = true;
  CheckOperatorButtons();
  last_reset_ = panel_.reset;
  last_start_ = panel_.start;
}

void LinkSupervision::CheckOperatorButtons() {
  const bool is_reset_edge = IsEdge(last_reset_, panel_.reset);
  const bool is_start_edge = IsEdge(last_start_, panel_.start);
  // Start counts only in a later frame than Reset, and what is held at that moment stays ignored.
  if (is_start_edge && is_start_needed_ && !latches_.any()) {
    is_start_needed_ = false;
    is_neutral_seen_ = false;
  }
  if (is_reset_edge && CanReset()) Reset();
}

bool LinkSupervision::CanReset() const {
  return latches_.any() && panel_.estop_a && !panel_.estop_b &&
         panel_.deadman != dbc::Deadman::kPanic && panel_.box_fault == 0 &&
         !panel_.button_channel_fault && !robot_stops_.estop && wish_.is_neutral &&
         FindLoss() == Refusal::kNone &&
         watch(BoxMessage::kMotion).IsFresh(limits_.frame_age, now_);
}

void LinkSupervision::Reset() {
  latches_ = {};
  for (FrameWatch& each : watches_) each.ForgetCrcErrors();
  is_start_needed_ = true;
  is_neutral_seen_ = false;
  ++outcome_.resets;
}

void LinkSupervision::TakeMotion() {
  if (panel_.button_channel_fault) latches_.box_fault = true;
  // Only a fresh motion frame can prove that the buttons are released.
  if (wish_.is_neutral) is_neutral_seen_ = true;
}

void LinkSupervision::TakeAxes(bool was_fresh) {
  // A stick that comes (back) deflected must not start anything.
  if (!was_fresh && !wish_.are_sticks_neutral) is_neutral_seen_ = false;
}

void LinkSupervision::CheckTimeouts() {
  const FrameWatch& safety = watch(BoxMessage::kSafety);
  const FrameWatch& motion = watch(BoxMessage::kMotion);
  is_link_alive_ =
      safety.IsFresh(limits_.frame_age, now_) && motion.IsFresh(limits_.frame_age, now_);
  if (safety.IsOlderThan(limits_.latch_age, now_) || motion.IsOlderThan(limits_.latch_age, now_)) {
    latches_.link = true;
  }
  if (contradiction_since_ && now_ - *contradiction_since_ > limits_.estop_contradiction) {
    latches_.estop_contradiction = true;
  }
  if (FindLoss() != Refusal::kNone) {
    EnterSafeStop();
  } else if (is_neutral_seen_) {
    is_safe_stop_ = false;
  }
}

Refusal LinkSupervision::FindLoss() const {
  if (bus_state_ == CanBusState::kDown) return Refusal::kBusDown;
  if (bus_state_ == CanBusState::kBusOff) return Refusal::kBusOff;
  const auto is_old = [this](BoxMessage role, Duration limit) {
    return watch(role).IsOlderThan(limit, now_);
  };
  if (is_old(BoxMessage::kSafety, limits_.frame_age)) return Refusal::kSafetyLost;
  if (is_old(BoxMessage::kMotion, limits_.frame_age)) return Refusal::kMotionLost;
  // Sticks are optional; silent ones are harmless as long as they were last seen at rest.
  if (is_old(BoxMessage::kAxes, limits_.frame_age) && !wish_.are_sticks_neutral) {
    return Refusal::kAxesLost;
  }
  if (is_old(BoxMessage::kHeartbeat, limits_.heartbeat_age)) return Refusal::kHeartbeatLost;
  return Refusal::kNone;
}

void LinkSupervision::EnterSafeStop() {
  is_neutral_seen_ = false;
  last_reset_.reset();
  last_start_.reset();
  if (is_safe_stop_) return;
  is_safe_stop_ = true;
  // The ramp begins when the frame became too old, however late that was noticed.
  TimePoint begin = now_;
  for (const BoxMessage role : {BoxMessage::kSafety, BoxMessage::kMotion}) {
    if (watch(role).IsOlderThan(limits_.frame_age, now_)) {
      begin = std::min(begin, *watch(role).last() + limits_.frame_age);
    }
  }
  ramp_.Start(outcome_.rate, begin, limits_.ramp);
}

void LinkSupervision::Evaluate() {
  Refusal refusal = FindRefusal();
  if (outcome_.motion_permitted && refusal != Refusal::kNone) is_neutral_seen_ = false;
  if (!MayRampDown()) ramp_.Cancel();

  outcome_.state = FindState(refusal);
  outcome_.motion_permitted = refusal == Refusal::kNone;
  outcome_.refusal = refusal;
  outcome_.rate = outcome_.motion_permitted ? wish_.rate : ramp_.At(now_);
  outcome_.inhibit_mask = outcome_.motion_permitted ? wish_.conflict : wish_.wanted;
  const dbc::InhibitReason conflict =
      wish_.conflict != 0 ? dbc::InhibitReason::kConflict : dbc::InhibitReason::kNone;
  outcome_.reason = Gravest(ReasonOf(refusal), conflict);
  outcome_.link_alarm =
      is_safe_stop_ || latches_.link || latches_.robot_link || latches_.crc || is_foreign_robot_;
  outcome_.box_fault_alarm = latches_.box_fault || latches_.estop_contradiction;
  outcome_.estop_alarm = latches_.estop || latches_.robot_estop;
}

Refusal LinkSupervision::FindRefusal() const {
  if (is_foreign_robot_) return Refusal::kForeignRobot;
  if (bus_state_ == CanBusState::kDown) return Refusal::kBusDown;
  if (bus_state_ == CanBusState::kBusOff) return Refusal::kBusOff;
  if (const Refusal latched = FindLatched(); latched != Refusal::kNone) return latched;
  if (const Refusal loss = FindLoss(); loss != Refusal::kNone) return loss;
  return FindNotReady();
}

Refusal LinkSupervision::FindLatched() const {
  if (latches_.estop) return Refusal::kEstop;
  if (latches_.robot_estop) return Refusal::kRobotEstop;
  if (latches_.estop_contradiction) return Refusal::kEstopContradiction;
  if (latches_.box_fault) return Refusal::kBoxFault;
  if (latches_.crc) return Refusal::kCrcFault;
  if (latches_.link) return Refusal::kLinkLatched;
  if (latches_.robot_link) return Refusal::kRobotLinkLatched;
  return Refusal::kNone;
}

Refusal LinkSupervision::FindNotReady() const {
  const bool has_box = watch(BoxMessage::kSafety).seen() && watch(BoxMessage::kMotion).seen() &&
                       watch(BoxMessage::kHeartbeat).seen();
  if (!has_box) return Refusal::kNoBox;
  if (IsSimulatorSilent()) return Refusal::kSimulatorSilent;
  if (panel_.key != dbc::KeySwitch::kOperate) return Refusal::kKey;
  if (!panel_.estop_a || panel_.estop_b) return Refusal::kEstopUnclear;
  if (panel_.nmt != dbc::NmtState::kOperational) return Refusal::kNotOperational;
  const bool is_every_stick_valid =
      std::ranges::all_of(panel_.axis, [](const dbc::Axis& axis) { return axis.valid; });
  if (panel_.mode == dbc::ControlMode::kNotAvailable ||
      panel_.speed_range == dbc::SpeedRange::kNotAvailable || !is_every_stick_valid) {
    return Refusal::kSignalInvalid;
  }
  if (is_start_needed_) return Refusal::kStartNeeded;
  if (panel_.deadman != dbc::Deadman::kEnabled) return Refusal::kDeadman;
  if (!is_neutral_seen_) return Refusal::kNeutralNeeded;
  return Refusal::kNone;
}

bool LinkSupervision::MayRampDown() const {
  // A ramp is for a link that went silent; a control that says stop stops at once.
  return is_safe_stop_ && !is_foreign_robot_ && !latches_.any() &&
         panel_.key == dbc::KeySwitch::kOperate && panel_.estop_a && !panel_.estop_b &&
         panel_.deadman == dbc::Deadman::kEnabled && !IsSimulatorSilent();
}

SystemState LinkSupervision::FindState(Refusal refusal) const {
  if (is_foreign_robot_) return SystemState::kFault;
  if (latches_.estop || latches_.robot_estop || latches_.estop_contradiction) {
    return SystemState::kEstopLatched;
  }
  if (latches_.any()) return SystemState::kFault;
  // A simulator that has not come up yet is no fault for the first moment.
  if (now_ - last_simulator_.value_or(*start_) > limits_.simulator_age) return SystemState::kFault;
  if (is_safe_stop_) return SystemState::kSafeStop;
  if (refusal == Refusal::kNone) return SystemState::kOperate;
  if (refusal == Refusal::kNoBox || panel_.key != dbc::KeySwitch::kOperate) {
    return SystemState::kStandby;
  }
  return SystemState::kReady;
}

bool LinkSupervision::IsSimulatorSilent() const {
  return !last_simulator_ || now_ - *last_simulator_ > limits_.simulator_age;
}

}  // namespace eod::bridge
