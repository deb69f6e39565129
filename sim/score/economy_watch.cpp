#include "sim/score/economy_watch.h"

#include <cmath>
#include <numbers>

#include "sim/robot/motion_id.h"

namespace eod::sim {
namespace {

constexpr double kDegreesPerRadian = 180 / std::numbers::pi;
constexpr int kFirstJointMotion = kFrontFlipperUp;  // two motions a joint from here on

}  // namespace

void EconomyWatch::Advance(const ScoreMoment& moment, EventList& events) {
  WatchChassis(moment, events);
  WatchJoints(moment, events);
  WatchLimits(moment, events);
}

bool EconomyWatch::Turns(Stroke& stroke, double moved, double dt_s) const {
  if (moved == 0) {
    stroke.idle_s += dt_s;
    return false;
  }
  const int direction = moved > 0 ? 1 : -1;
  const bool in_time = stroke.idle_s <= rules_.reversal_time;
  const bool turns = stroke.direction == -direction;
  if (turns || !in_time) {
    stroke.before = turns && in_time ? stroke.length : 0;
    stroke.length = 0;
    stroke.blamed = false;
  }
  stroke.direction = direction;
  stroke.length += std::abs(moved);
  stroke.idle_s = 0;
  return turns && in_time;
}

void EconomyWatch::WatchChassis(const ScoreMoment& moment, EventList& events) {
  const double moved[] = {moment.now->speed_mps, moment.now->turn_rate_dps};
  for (int way = 0; way < 2; ++way) {
    if (!Turns(chassis_[way], moved[way], moment.dt_s)) continue;
    ++count_.reversals;
    events.Add(moment, ScoreMark::kReversal, -rules_.reversal_points, way);
  }
}

void EconomyWatch::WatchJoints(const ScoreMoment& moment, EventList& events) {
  for (int j = 0; j < kJoints; ++j) {
    const double now = moment.now->joint[j];
    const double moved = has_coordinates_ ? std::remainder(now - coordinate_[j], 360.0) : 0;
    coordinate_[j] = now;
    Stroke& stroke = joints_[j];
    Turns(stroke, moved, moment.dt_s);
    const bool is_motion = stroke.before > rules_.undone_angle * kDegreesPerRadian;
    if (stroke.blamed || !is_motion || stroke.length < rules_.undone_share * stroke.before)
      continue;
    stroke.blamed = true;
    ++count_.undone;
    events.Add(moment, ScoreMark::kUndone, -rules_.undone_points, j, -1, stroke.before);
  }
  has_coordinates_ = true;
}

void EconomyWatch::WatchLimits(const ScoreMoment& moment, EventList& events) {
  const ScoreSample& now = *moment.now;
  const uint32_t refused = now.wanted_mask & now.inhibit_mask;
  for (int j = 0; j < kJointCount; ++j) {
    const uint32_t bit = 1u << j;
    if ((now.limit_flags & bit) == 0) at_limit_ &= ~bit;
    const bool driven =
        (now.limit_flags & bit) != 0 && (refused >> (kFirstJointMotion + 2 * j) & 3u) != 0;
    if (!driven || j == kGripperOpening || (at_limit_ & bit) != 0) continue;
    at_limit_ |= bit;
    ++count_.limits;
    events.Add(moment, ScoreMark::kLimit, -rules_.limit_points, j);
  }
}

}  // namespace eod::sim
