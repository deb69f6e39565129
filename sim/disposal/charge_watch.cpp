#include "sim/disposal/charge_watch.h"

#include <algorithm>
#include <cmath>

#include "sim/disposal/charge.h"

namespace eod::sim {
namespace {

/// Angle of the charge's axis against the vertical, 0 .. 90 degrees.
double FromVertical(const Eigen::Isometry3d& X_MO) {
  const Eigen::Vector3d axis = X_MO.linear().col(2);
  return std::atan2(std::hypot(axis.x(), axis.y()), std::abs(axis.z()));
}

constexpr double kQuarterTurn = 1.5707963267948966;

bool IsOver(BombState state) {
  return state == BombState::kExploded || state == BombState::kDisrupted;
}

}  // namespace

ChargeWatch::ChargeWatch(const ModuleModel& module, const ChargeRules& charge,
                         const VesselRules& vessel)
    : module_(module), charge_rules_(charge), vessel_rules_(vessel) {
  for (const int body : ChargesOf(module)) charges_.push_back({.body = body});
  histories_.resize(charges_.size());
  Reset();
}

void ChargeWatch::Reset() {
  main_ = 0;
  for (size_t i = 0; i < charges_.size(); ++i) {
    const MovableObject& movable = module_.movables[charges_[i].body];
    charges_[i] = {.body = charges_[i].body};
    histories_[i] = {.lies = FromVertical(movable.X_MO) > kQuarterTurn / 2,
                     .highest = LowestPoint(*movable.explosive, movable.X_MO)};
  }
}

const ChargeState* ChargeWatch::Find(int body) const {
  const auto found = std::find_if(charges_.begin(), charges_.end(),
                                  [body](const auto& charge) { return charge.body == body; });
  return found == charges_.end() ? nullptr : &*found;
}

const ChargeState* ChargeWatch::main() const {
  return charges_.empty() ? nullptr : &charges_[main_];
}

void ChargeWatch::Settle(int body, BombState state) {
  for (size_t i = 0; i < charges_.size(); ++i) {
    if (charges_[i].body != body) continue;
    charges_[i] = {.body = body, .state = state, .in_vessel = charges_[i].in_vessel};
    main_ = static_cast<int>(i);
  }
}

std::optional<Detonation> ChargeWatch::Update(std::span<const BodyState> bodies,
                                              std::span<const char> touched, int held) {
  std::optional<Detonation> first;
  for (size_t i = 0; i < charges_.size(); ++i) {
    const int body = charges_[i].body;
    if (IsOver(charges_[i].state) || static_cast<size_t>(body) >= bodies.size()) continue;
    const BodyState& state = bodies[body];
    const bool by_lines = static_cast<size_t>(body) < touched.size() && touched[body] != 0;
    const DetonationCause cause =
        UpdateOne(i, state, by_lines || state.touched_by != 0, body == held);
    if (cause != DetonationCause::kNone && !first) first = Detonation{body, cause};
  }
  return first;
}

DetonationCause ChargeWatch::UpdateOne(size_t index, const BodyState& body, bool touched,
                                       bool held) {
  ChargeState& charge = charges_[index];
  History& history = histories_[index];
  charge.touched = touched && !held;
  if (touched || held) main_ = static_cast<int>(index);
  if (held) {
    UpdateHeld(charge, history, body);
    return DetonationCause::kNone;
  }
  if (history.was_held) {
    history.was_held = false;
    history.airborne = true;
  }
  return UpdateFree(charge, history, body);
}

void ChargeWatch::UpdateHeld(ChargeState& charge, History& history, const BodyState& body) const {
  if (!history.was_held) history.p_taken = body.X_MO.translation();
  history.was_held = true;
  history.highest = LowestPoint(*module_.movables[charge.body].explosive, body.X_MO);
  charge.tilt = TiltOf(history, body);
  charge.disturbed = charge.unstable = charge.in_vessel = false;
  const bool moved = (body.X_MO.translation() - history.p_taken).norm() > charge_rules_.carried;
  if (moved || charge.state != BombState::kCarried) {
    charge.state = moved ? BombState::kCarried : BombState::kGrasped;
  }
}

DetonationCause ChargeWatch::UpdateFree(ChargeState& charge, History& history,
                                        const BodyState& body) const {
  const ExplosiveSpec& explosive = *module_.movables[charge.body].explosive;
  const double lowest = LowestPoint(explosive, body.X_MO);
  charge.tilt = TiltOf(history, body);
  charge.in_vessel = IsInVessel(body, lowest);
  charge.disturbed = charge.unstable = false;
  if (charge.in_vessel) {
    history.highest = lowest;
    history.airborne = history.airborne && !body.touches_ground;
    const bool rests = !body.is_moving && !history.airborne;
    charge.state = rests ? BombState::kInCan : BombState::kDropped;
    return DetonationCause::kNone;
  }
  const double fallen = history.highest - lowest;
  history.highest = body.touches_ground ? lowest : std::max(history.highest, lowest);
  if (body.touches_ground && fallen > charge_rules_.drop) return DetonationCause::kDropped;
  history.airborne = history.airborne && !body.touches_ground;
  if (history.airborne) {
    charge.state = BombState::kDropped;
    return DetonationCause::kNone;
  }
  charge.disturbed = charge.tilt > charge_rules_.disturbed;
  charge.unstable = charge.tilt > charge_rules_.unstable;
  charge.state = charge.disturbed ? BombState::kTilted
                 : charge.touched ? BombState::kTouched
                                  : BombState::kPlaced;
  const double topples = history.lies ? std::atan2(explosive.half_height, explosive.radius)
                                      : std::atan2(explosive.radius, explosive.half_height);
  return charge.tilt > topples ? DetonationCause::kTipped : DetonationCause::kNone;
}

double ChargeWatch::TiltOf(const History& history, const BodyState& body) const {
  const double from_vertical = FromVertical(body.X_MO);
  return history.lies ? kQuarterTurn - from_vertical : from_vertical;
}

bool ChargeWatch::IsInVessel(const BodyState& body, double lowest) const {
  return std::any_of(module_.vessels.begin(), module_.vessels.end(), [&](const auto& vessel) {
    return IsInside(vessel, body.X_MO.translation(), lowest, vessel_rules_.net_sag);
  });
}

}  // namespace eod::sim
