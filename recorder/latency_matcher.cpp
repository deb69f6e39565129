#include "recorder/latency_matcher.h"

#include <cmath>

namespace eod::recorder {
namespace {

constexpr Duration kPressTimeout = std::chrono::seconds(1);

// Far below the first step of any motion (a start at 1 m/s2 moves 16 um in 4 ms), far above
// rounding.
constexpr double kMoved = 1e-7;

double Milliseconds(Duration duration) { return ToSeconds(duration) * 1e3; }

template <size_t N>
bool Differ(const std::array<double, N>& a, const std::array<double, N>& b) {
  for (size_t i = 0; i < N; ++i) {
    if (std::abs(a[i] - b[i]) > kMoved) return true;
  }
  return false;
}

bool HasMoved(const RobotStateSeen& from, const RobotStateSeen& to) {
  return Differ(from.position_m, to.position_m) || Differ(from.attitude_deg, to.attitude_deg) ||
         Differ(from.joint, to.joint);
}

}  // namespace

void LatencyMatcher::OnMotionFrame(TimePoint stamp, const Buttons& held) {
  const bool may_start = buttons_known_ && permitted_ && standing_still_ && !press_;
  for (size_t motion = 0; motion < held.size(); ++motion) {
    const bool pressed = held[motion] && !held_[motion];
    const bool inhibited = last_state_ && (last_state_->inhibit_mask >> motion & 1U) != 0;
    if (pressed && may_start && !inhibited && !press_) press_ = Press{motion, stamp};
  }
  if (press_ && !held[press_->motion]) press_.reset();
  held_ = held;
  buttons_known_ = true;
}

void LatencyMatcher::OnRobotState(TimePoint received, const RobotStateSeen& state) {
  const bool moved = last_state_ && HasMoved(*last_state_, state);
  MatchPress(received, moved);
  standing_still_ = last_state_ && !moved;
  last_state_ = state;
}

void LatencyMatcher::MatchPress(TimePoint received, bool moved) {
  if (!press_) return;
  if (moved) {
    button_to_pose_ms_.push_back(Milliseconds(received - press_->stamp));
    press_.reset();
  } else if (received - press_->stamp > kPressTimeout) {
    ++unanswered_presses_;
    press_.reset();
  }
}

void LatencyMatcher::OnCollisionAlarm(TimePoint step_time, bool raised) {
  contact_.reset();
  if (!raised) return;
  // The lamp's frame and the alarm come on two sockets: the frame may be here first.
  if (!lamp_on_) {
    contact_ = step_time;
  } else if (lamp_on_since_ >= step_time) {
    contact_to_lamp_ms_.push_back(Milliseconds(lamp_on_since_ - step_time));
  }
}

void LatencyMatcher::OnAlarmFrame(TimePoint stamp, bool collision_lamp_on) {
  if (collision_lamp_on && !lamp_on_) {
    lamp_on_since_ = stamp;
    if (contact_) contact_to_lamp_ms_.push_back(Milliseconds(stamp - *contact_));
    contact_.reset();
  }
  lamp_on_ = collision_lamp_on;
}

}  // namespace eod::recorder
