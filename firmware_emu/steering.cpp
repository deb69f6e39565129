#include "firmware_emu/steering.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "firmware_emu/odometer.h"

namespace eod::box {
namespace {

using std::chrono::milliseconds;

// What a practised operator has in the fingers about this robot [E]; what it gets wrong, the next
// look corrects.
constexpr double kLeastLatency = 0.025;               // [s] from finger to motor
constexpr double kBraking = 1;                        // [m/s^2]
constexpr double kTurnBraking = 90;                   // [deg/s^2]
constexpr double kTurnRate = 30;                      // [deg/s]
constexpr double kRangeSpeed[] = {0.10, 0.30, 0.67};  // [m/s] creep, low, high

// How such a person drives [E].
constexpr double kLowFrom = 0.6;              // [m] before the goal: low, and creep
constexpr double kCreepFrom = 0.15;           // [m]
constexpr double kStandoff = 0.25;            // [m] before the end of an approach, to look again
constexpr double kFineTurn = 0.1;             // share of the speed for the last degrees
constexpr double kFineFrom = 3;               // [deg]
constexpr double kLookAway = 0.3;             // [m] nearer, a point says nothing about the heading
constexpr double kWrongWay = 15;              // [deg] stop and turn on the spot
constexpr double kSteerFrom = 0.7;            // [deg] correct the heading on the way
constexpr double kDriveTolerance = 0.03;      // [m]
constexpr double kApproachTolerance = 0.004;  // [m]
constexpr double kTurnTolerance = 0.2;        // [deg]
constexpr double kNearTolerance = 0.15;       // [deg] before the last part of an approach
constexpr Duration kControlTime = milliseconds(60);  // until a speed control has its effect
constexpr Duration kStandTime = milliseconds(120);
constexpr Duration kLookTime = milliseconds(50);
constexpr double kFineWay = 0.03;                         // [m] for a counted time, not by looking
constexpr double kLeastTap = 0.025;                       // [s] a shorter one may be missed
constexpr Duration kAwaitTime = std::chrono::seconds(1);  // nothing will come of it any more
constexpr Duration kStuckTime = std::chrono::seconds(5);

constexpr uint32_t kForward = 1u << 0, kReverse = 1u << 1, kLeft = 1u << 2, kRight = 1u << 3;

/// Way that is still covered if the button is let go now, at `speed` toward the goal.
double RunOut(double speed, double fastest, double braking, double latency) {
  const double then = std::max(speed, std::min(speed + braking * latency, fastest));
  const double rise = std::min(latency, (then - speed) / braking);
  return (speed + then) / 2 * rise + then * (latency - rise) + then * then / (2 * braking);
}

Duration Seconds(double seconds) { return std::chrono::microseconds(std::llround(seconds * 1e6)); }

double Degrees(double radians) { return radians * (180 / std::numbers::pi); }

}  // namespace

void Steering::Begin(const Manoeuvre& manoeuvre, TimePoint now, const OperatorHands& hands) {
  const dbc::PanelState& controls = hands.inputs().controls;
  manoeuvre_ = manoeuvre;
  phase_ = Phase::kTurn;
  standoff_ = manoeuvre.kind == Manoeuvre::Kind::kApproach ? kStandoff : 0;
  held_ = 0;
  latency_ = kLeastLatency;
  awaits_motion_ = false;
  tap_end_.reset();
  correction_end_ = correction_seen_ = now;
  cruise_ = range_ = controls.speed_range;
  full_limit_ = limit_ = controls.speed_limit;
  control_moved_ = TimePoint{};
  moving_ = progress_ = now;
  progress_heading_ = 1000;  // any look is progress
}

bool Steering::goal_is_seen(const Sight& sight) const {
  return manoeuvre_.object.empty() || sight.Find(manoeuvre_.object) != nullptr;
}

Steering::Gap Steering::Measure(const Sight& sight) const {
  const SeenObject* object = sight.Find(manoeuvre_.object);
  if (manoeuvre_.kind == Manoeuvre::Kind::kTurnTo && object == nullptr) {
    return {.heading_deg = WrapDegrees(manoeuvre_.heading_deg - sight.heading_deg)};
  }
  const FromRobot goal = object == nullptr
                             ? SeenFromRobot(sight, manoeuvre_.x, manoeuvre_.y)
                             : SeenFromRobot(sight, object->position[0], object->position[1]);
  if (manoeuvre_.kind == Manoeuvre::Kind::kTurnTo) return {.heading_deg = goal.bearing_deg()};
  const double distance = goal.distance();
  Gap gap{.way = goal.ahead - manoeuvre_.ahead};
  if (distance < kLookAway) return gap;
  // The goal is to pass `side` to the right of the robot's axis.
  const double beside = Degrees(std::asin(std::clamp(manoeuvre_.side / distance, -1.0, 1.0)));
  const double rear_first = manoeuvre_.backwards ? 180 : 0;
  gap.heading_deg = WrapDegrees(goal.bearing_deg() + beside + rear_first);
  return gap;
}

Steering::Progress Steering::Advance(TimePoint now, const Sight& sight, OperatorHands& hands) {
  const Gap gap = Measure(sight);
  LearnLatency(sight, now);
  if (IsStuck(sight, now)) return Progress::kStuck;
  if (IsTapping(now, hands)) return Progress::kUnderWay;
  switch (phase_) {
    case Phase::kTurn:
      Turn(gap, sight, now, hands);
      break;
    case Phase::kGo:
      Go(gap, sight, now, hands);
      break;
    case Phase::kSettle:
      if (HasStood(sight, now) && Settle(gap)) return Progress::kThere;
      break;
  }
  return Progress::kUnderWay;
}

/// On the spot: a turn, a look at what is left of it, and so on until it is right.
void Steering::Turn(const Gap& gap, const Sight& sight, TimePoint now, OperatorHands& hands) {
  const double left = std::abs(gap.heading_deg);
  if (held_ == 0) {
    if (!HasStood(sight, now)) return;
    if (left <= HeadingTolerance(gap)) {
      SetLimit(full_limit_, now, hands);
      phase_ = manoeuvre_.kind == Manoeuvre::Kind::kTurnTo ? Phase::kSettle : Phase::kGo;
      return;
    }
    SetLimit(left > kFineFrom ? full_limit_ : full_limit_ * kFineTurn, now, hands);
    if (now - control_moved_ < kControlTime) return;
  }
  const double fastest = kTurnRate * limit_;
  const uint32_t turn = gap.heading_deg > 0 ? kLeft : kRight;
  const double toward = turn == kLeft ? sight.turn_rate_dps : -sight.turn_rate_dps;
  const bool is_short = left <= RunOut(std::max(0.0, toward), fastest, kTurnBraking, latency_);
  if (held_ == 0 && (is_short || left <= kFineFrom)) {
    Tap(turn, left / fastest, now, hands);
  } else {
    Hold(is_short || (held_ != 0 && held_ != turn) ? 0 : turn, now, hands);
  }
}

double Steering::HeadingTolerance(const Gap& gap) const {
  if (manoeuvre_.kind == Manoeuvre::Kind::kTurnTo) return kTurnTolerance;
  const bool is_last_part =
      manoeuvre_.kind == Manoeuvre::Kind::kApproach && std::abs(gap.way) < 2 * kStandoff;
  return is_last_part ? kNearTolerance : kSteerFrom;
}

void Steering::Go(const Gap& gap, const Sight& sight, TimePoint now, OperatorHands& hands) {
  if (gap.way < standoff_) standoff_ = 0;
  const double way = gap.way - standoff_;
  const double left = std::abs(way);
  ChooseRange(left, now, hands);
  if (held_ == 0 && now - control_moved_ < kControlTime) return;
  const double fastest = kRangeSpeed[static_cast<size_t>(range_)] * limit_;
  const double toward = way > 0 ? sight.speed_mps : -sight.speed_mps;
  const bool is_short = left <= RunOut(std::max(0.0, toward), fastest, kBraking, latency_);
  const uint32_t drive = way > 0 ? kForward : kReverse;
  const bool has_passed = (held_ & (kForward | kReverse) & ~drive) != 0;
  if (held_ == 0 && (is_short || left <= kFineWay)) {
    standoff_ = 0;
    phase_ = Phase::kSettle;
    Tap(drive, left / fastest, now, hands);
  } else if (is_short || has_passed || std::abs(gap.heading_deg) > kWrongWay) {
    if (is_short) standoff_ = 0;
    phase_ = Phase::kSettle;
    Hold(0, now, hands);
  } else {
    Hold(drive | Correct(gap.heading_deg, now), now, hands);
  }
}

/// Slower toward the end, earlier by what is driven until that acts.
void Steering::ChooseRange(double left, TimePoint now, OperatorHands& hands) {
  using dbc::SpeedRange;
  const auto until = [this, left](double way, SpeedRange range) {
    return left > way + latency_ * kRangeSpeed[static_cast<size_t>(range)];
  };
  const SpeedRange most = until(kLowFrom, SpeedRange::kHigh)    ? SpeedRange::kHigh
                          : until(kCreepFrom, SpeedRange::kLow) ? SpeedRange::kLow
                                                                : SpeedRange::kCreep;
  SetRange(std::min(cruise_, most), now, hands);
}

/// The turn button to hold on the way: a touch as long as the heading needs, then a look at what
/// came of it.
uint32_t Steering::Correct(double heading_gap, TimePoint now) {
  if (now < correction_end_) return held_ & (kLeft | kRight);
  if (now < correction_seen_ || std::abs(heading_gap) <= kSteerFrom) return 0;
  const Duration length =
      Seconds(std::max(std::abs(heading_gap) / (kTurnRate * limit_), kLeastTap));
  correction_end_ = now + length;
  correction_seen_ = correction_end_ + length + Seconds(latency_) + kLookTime;
  return heading_gap > 0 ? kLeft : kRight;
}

/// Standing after the way: true if all is right, else what is left is gone over again.
bool Steering::Settle(const Gap& gap) {
  const bool is_approach = manoeuvre_.kind == Manoeuvre::Kind::kApproach;
  const double way = is_approach ? kApproachTolerance : kDriveTolerance;
  const double heading = manoeuvre_.kind == Manoeuvre::Kind::kDriveTo ? kWrongWay : kTurnTolerance;
  if (std::abs(gap.way) <= way && std::abs(gap.heading_deg) <= heading) {
    return true;
  }
  phase_ = Phase::kTurn;
  return false;
}

void Steering::Hold(uint32_t motions, TimePoint now, OperatorHands& hands) {
  const uint32_t let_go = held_ & ~motions, pressed = motions & ~held_;
  if (let_go != 0) hands.Apply({.control = Control::kRelease, .motions = let_go}, now);
  if (pressed != 0) hands.Apply({.control = Control::kPress, .motions = pressed}, now);
  if (held_ == 0 && motions != 0) {
    pressed_ = now;
    awaits_motion_ = true;
  }
  if (motions != held_) {
    moving_ = now;
    tap_end_.reset();
  }
  held_ = motions;
}

/// Held for t, a motion covers its rate times t, run-out included, however late it begins.
void Steering::Tap(uint32_t motions, double seconds, TimePoint now, OperatorHands& hands) {
  Hold(motions, now, hands);
  tap_end_ = now + Seconds(std::max(seconds, kLeastTap));
}

bool Steering::IsTapping(TimePoint now, OperatorHands& hands) {
  if (tap_end_ && now >= *tap_end_) Hold(0, now, hands);
  return tap_end_.has_value();
}

/// From pressing a button to the first motion that is seen.
void Steering::LearnLatency(const Sight& sight, TimePoint now) {
  if (!awaits_motion_) return;
  const Duration waited = now - pressed_;
  const bool moves = sight.speed_mps != 0 || sight.turn_rate_dps != 0;
  if (moves) latency_ = std::max(ToSeconds(waited), kLeastLatency);
  if (moves || waited > kAwaitTime) awaits_motion_ = false;
}

void Steering::SetRange(dbc::SpeedRange range, TimePoint now, OperatorHands& hands) {
  if (range == range_) return;
  range_ = range;
  control_moved_ = now;
  hands.Apply({.control = Control::kSpeed, .choice = static_cast<int>(range)}, now);
}

void Steering::SetLimit(double share, TimePoint now, OperatorHands& hands) {
  if (share == limit_) return;
  limit_ = share;
  control_moved_ = now;
  hands.Apply({.control = Control::kSpeedLimit, .share = share}, now);
}

void Steering::End(TimePoint now, OperatorHands& hands) {
  Hold(0, now, hands);
  SetRange(cruise_, now, hands);
  SetLimit(full_limit_, now, hands);
}

bool Steering::HasStood(const Sight& sight, TimePoint now) {
  if (held_ != 0 || sight.speed_mps != 0 || sight.turn_rate_dps != 0) moving_ = now;
  return !awaits_motion_ && now - moving_ >= kStandTime;
}

bool Steering::IsStuck(const Sight& sight, TimePoint now) {
  double moved = 0;
  for (size_t i = 0; i < 3; ++i) {
    moved = std::max(moved, std::abs(sight.position[i] - progress_position_[i]));
  }
  constexpr double kStep = 0.002, kTurn = 0.1;  // [m], [deg]
  const double turned = std::abs(WrapDegrees(sight.heading_deg - progress_heading_));
  if (held_ == 0 || moved > kStep || turned > kTurn) {
    progress_ = now;
    progress_position_ = sight.position;
    progress_heading_ = sight.heading_deg;
  }
  return now - progress_ >= kStuckTime;
}

std::string Steering::Left(const Sight& sight) const {
  const Gap gap = Measure(sight);
  return fmt::format("{:.3f} m and {:.1f} deg are left", gap.way, gap.heading_deg);
}

}  // namespace eod::box
