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
constexpr double kLatency = 0.025;                    // [s] from finger to motor
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
constexpr Duration kStuckTime = std::chrono::seconds(5);

constexpr uint32_t kForward = 1u << 0, kReverse = 1u << 1, kLeft = 1u << 2, kRight = 1u << 3;

/// Way that is still covered if the button is let go now, at `speed` toward the goal.
double RunOut(double speed, double fastest, double braking) {
  const double then = std::max(speed, std::min(speed + braking * kLatency, fastest));
  return (speed + then) / 2 * kLatency + then * then / (2 * braking);
}

double Degrees(double radians) { return radians * (180 / std::numbers::pi); }

}  // namespace

void Steering::Begin(const Manoeuvre& manoeuvre, TimePoint now, const OperatorHands& hands) {
  const dbc::PanelState& controls = hands.inputs().controls;
  manoeuvre_ = manoeuvre;
  phase_ = Phase::kTurn;
  standoff_ = manoeuvre.kind == Manoeuvre::Kind::kApproach ? kStandoff : 0;
  held_ = 0;
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
  if (IsStuck(sight, now)) return Progress::kStuck;
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
  if (held_ == 0) {
    if (!HasStood(sight, now)) return;
    if (std::abs(gap.heading_deg) <= HeadingTolerance(gap)) {
      SetLimit(full_limit_, now, hands);
      phase_ = manoeuvre_.kind == Manoeuvre::Kind::kTurnTo ? Phase::kSettle : Phase::kGo;
      return;
    }
    SetLimit(std::abs(gap.heading_deg) > kFineFrom ? full_limit_ : full_limit_ * kFineTurn, now,
             hands);
    if (now - control_moved_ < kControlTime) return;
  }
  const int turn = Sideways(gap.heading_deg, 0, sight.turn_rate_dps);
  Hold(turn > 0 ? kLeft : turn < 0 ? kRight : 0, now, hands);
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
  using dbc::SpeedRange;
  const SpeedRange most = left > kLowFrom     ? SpeedRange::kHigh
                          : left > kCreepFrom ? SpeedRange::kLow
                                              : SpeedRange::kCreep;
  SetRange(std::min(cruise_, most), now, hands);
  const double sign = way > 0 ? 1 : -1;
  const double fastest = kRangeSpeed[static_cast<size_t>(range_)] * limit_;
  const bool is_there = left <= RunOut(std::max(0.0, sign * sight.speed_mps), fastest, kBraking);
  const uint32_t drive = way > 0 ? kForward : kReverse;
  const bool has_passed = (held_ & (kForward | kReverse) & ~drive) != 0;
  if (is_there || has_passed || std::abs(gap.heading_deg) > kWrongWay) {
    if (is_there) standoff_ = 0;
    Hold(0, now, hands);
    phase_ = Phase::kSettle;
    return;
  }
  const int turn = Sideways(gap.heading_deg, kSteerFrom, sight.turn_rate_dps);
  Hold(drive | (turn > 0 ? kLeft : turn < 0 ? kRight : 0), now, hands);
}

/// Which way to hold the turn buttons: 1 left, -1 right. A held one until the run-out will do.
int Steering::Sideways(double heading_gap, double tolerance, double turn_rate) const {
  const int held = (held_ & kLeft) != 0 ? 1 : (held_ & kRight) != 0 ? -1 : 0;
  const double fastest = kTurnRate * limit_;
  if (held != 0) {
    const double speed = std::max(0.0, held * turn_rate);
    return held * heading_gap > RunOut(speed, fastest, kTurnBraking) ? held : 0;
  }
  const double run_out = std::copysign(RunOut(std::abs(turn_rate), 0, kTurnBraking), turn_rate);
  const double rest = heading_gap - (turn_rate == 0 ? 0 : run_out);
  if (std::abs(rest) <= tolerance) return 0;
  return rest > 0 ? 1 : -1;
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
  if (motions != held_) moving_ = now;
  held_ = motions;
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
  return now - moving_ >= kStandTime;
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
