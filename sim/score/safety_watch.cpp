#include "sim/score/safety_watch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/disposal/disposal_status.h"
#include "sim/geometry/pose.h"
#include "sim/robot/motion_id.h"

namespace eod::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kArmed = 2, kPressed = 2;  // contacts of the fire panel
enum Camera : int { kQuad, kDrive, kGripper, kMast, kRear };

double TiltOf(const ScoreSample& now) {
  return TiltOf(
      Attitude{.heading = 0, .pitch = now.pitch_deg * kDegree, .roll = now.roll_deg * kDegree});
}

/// Whether the picture chosen shows the way ahead, or that behind.
bool SeesTheWay(const ScoreSample& now, int direction, double view_pan) {
  if (now.camera_select == kQuad) return true;
  if (now.camera_select == (direction > 0 ? kDrive : kRear)) return true;
  const double pan = std::abs(std::remainder(now.joint[kCameraPan], 360.0)) * kDegree;
  const double off = direction > 0 ? pan : std::numbers::pi - pan;
  return now.camera_select == kMast && off <= view_pan;
}

}  // namespace

SafetyWatch::SafetyWatch(const Scenario& scenario, const Rules& rules)
    : rules_(rules.score),
      both_within_(rules.disrupter.both_within),
      tilt_limit_(scenario.rubric.tilt > 0 ? scenario.rubric.tilt : rules.tilt.alarm) {
  for (const TaskStep& step : scenario.steps) kinds_.push_back(step.kind);
  Reset();
}

void SafetyWatch::Reset() {
  count_ = {};
  contacts_ = 0;
  pushed_s_ = 0;
  pushing_event_ = -1;
  is_tilted_ = false;
  tilt_event_ = -1;
  tilt_peak_ = 0;
  touched_s_ = -1;
  held_s_ = 2 * rules_.touch_memory;
  buttons_ = {};
  fire_state_ = 0;
  armed_driving_ = false;
  unseen_way_ = 0;
  direction_ = 0;
}

void SafetyWatch::Advance(const ScoreMoment& moment, std::span<const int> objects,
                          EventList& events) {
  WatchContacts(moment, objects, events);
  WatchPushing(moment, events);
  WatchTilt(moment, events);
  WatchTouches(moment, events);
  WatchFire(moment, events);
  WatchView(moment, events);
}

void SafetyWatch::WatchContacts(const ScoreMoment& moment, std::span<const int> objects,
                                EventList& events) {
  const uint32_t fresh = moment.now->contact_parts & ~contacts_;
  contacts_ = moment.now->contact_parts;
  if (fresh == 0 || IsAskedFor(moment, objects)) return;
  ++count_.collisions;
  events.Add(moment, ScoreMark::kCollision, -rules_.collision_points, -1, moment.contact);
}

bool SafetyWatch::IsAskedFor(const ScoreMoment& moment, std::span<const int> objects) const {
  const auto step = static_cast<size_t>(moment.step_before);
  if (step >= kinds_.size()) return false;
  const TaskStep::Kind kind = kinds_[step];
  const bool touches = kind == TaskStep::Kind::kContact || kind == TaskStep::Kind::kGrasp;
  const bool sets_down = kind == TaskStep::Kind::kPlaceInVessel && moment.now->contact_by_held;
  const bool climbs =
      (kind == TaskStep::Kind::kClimb || kind == TaskStep::Kind::kReach) && objects[step] >= 0;
  return (touches || sets_down || climbs) && (objects[step] < 0 || objects[step] == moment.contact);
}

void SafetyWatch::WatchPushing(const ScoreMoment& moment, EventList& events) {
  if ((moment.now->wanted_mask & moment.now->blocked_mask) == 0) {
    pushed_s_ = 0;
    pushing_event_ = -1;
    return;
  }
  const double before = std::max(0.0, pushed_s_ - rules_.push_grace);
  pushed_s_ += moment.dt_s;
  const double counted = std::max(0.0, pushed_s_ - rules_.push_grace);
  if (counted == 0) return;
  count_.pushing_s += counted - before;
  const double points = -rules_.push_points * counted;
  if (before == 0) {
    pushing_event_ = events.Add(moment, ScoreMark::kPushing, points, -1, moment.contact, counted);
  } else {
    events.Extend(pushing_event_, points, counted);
  }
}

void SafetyWatch::WatchTilt(const ScoreMoment& moment, EventList& events) {
  const double tilt = TiltOf(*moment.now);
  if (is_tilted_) {
    tilt_peak_ = std::max(tilt_peak_, tilt);
    events.Extend(tilt_event_, -rules_.tilt_points, tilt_peak_ / kDegree);
    is_tilted_ = tilt > tilt_limit_ - rules_.tilt_hysteresis;
  } else if (tilt > tilt_limit_) {
    is_tilted_ = true;
    tilt_peak_ = tilt;
    ++count_.tilts;
    tilt_event_ = events.Add(moment, ScoreMark::kTilt, -rules_.tilt_points, -1, -1, tilt / kDegree);
  }
}

void SafetyWatch::WatchTouches(const ScoreMoment& moment, EventList& events) {
  held_s_ = moment.now->held_object.empty() ? held_s_ + moment.dt_s : 0;
  if (held_s_ <= rules_.touch_memory) {
    touched_s_ = -1;
  } else if (moment.now->charge_touched) {
    if (touched_s_ < 0) touch_began_s_ = moment.now->mission_s;
    touched_s_ = 0;
  } else if (touched_s_ >= 0) {
    touched_s_ += moment.dt_s;
    if (touched_s_ <= rules_.touch_memory) return;
    touched_s_ = -1;
    ++count_.touches;
    const int place = events.Add(moment, ScoreMark::kTouch, -rules_.touch_points);
    events.Antedate(place, touch_began_s_);
  }
}

void SafetyWatch::WatchFire(const ScoreMoment& moment, EventList& events) {
  const ScoreSample& now = *moment.now;
  const bool left = now.fire_left == kPressed, right = now.fire_right == kPressed;
  WatchButton(moment, left, right, 0, events);
  WatchButton(moment, right, left, 1, events);
  const bool armed_driving =
      now.arm_key == kArmed && (now.speed_mps != 0 || now.turn_rate_dps != 0);
  const auto blame = [&](ScoreMark mark) {
    ++count_.fire_rules;
    events.Add(moment, mark, -rules_.fire_points);
  };
  if (armed_driving && !armed_driving_) blame(ScoreMark::kArmedDriving);
  // The same time of arming is blamed once, however often the robot stops on its way.
  armed_driving_ = now.arm_key == kArmed && (armed_driving_ || armed_driving);
  const int time_out = static_cast<int>(FireState::kTimeOut);
  if (now.fire_state == time_out && fire_state_ != time_out) blame(ScoreMark::kFireTimeOut);
  fire_state_ = now.fire_state;
}

/// A press is blamed once: at once if nothing was ready for it, or when it stays alone too long.
void SafetyWatch::WatchButton(const ScoreMoment& moment, bool pressed, bool other, int button,
                              EventList& events) {
  Button& one = buttons_[static_cast<size_t>(button)];
  if (!pressed) {
    one = {};
    return;
  }
  const auto state = static_cast<FireState>(moment.now->fire_state);
  const bool may_fire = state == FireState::kReady || state == FireState::kFired;
  const bool too_soon = !one.pressed && !may_fire;
  one.alone_s = other ? 0 : one.alone_s + moment.dt_s;
  const bool alone = one.alone_s > both_within_ && state != FireState::kFired;
  one.pressed = true;
  if (one.blamed || !(too_soon || alone)) return;
  one.blamed = true;
  ++count_.fire_rules;
  events.Add(moment, too_soon ? ScoreMark::kFireButton : ScoreMark::kOneHand, -rules_.fire_points,
             button);
}

void SafetyWatch::WatchView(const ScoreMoment& moment, EventList& events) {
  const double speed = moment.now->speed_mps;
  const int direction = speed > 0 ? 1 : speed < 0 ? -1 : 0;
  if (direction == 0) return;
  if (direction != direction_ || SeesTheWay(*moment.now, direction, rules_.view_pan)) {
    unseen_way_ = 0;
  }
  direction_ = direction;
  if (SeesTheWay(*moment.now, direction, rules_.view_pan)) return;
  const double before = unseen_way_;
  unseen_way_ += moment.way;
  if (before > rules_.unseen_way || unseen_way_ <= rules_.unseen_way) return;
  ++count_.unseen;
  events.Add(moment, ScoreMark::kUnseen, -rules_.unseen_points, direction);
}

}  // namespace eod::sim
