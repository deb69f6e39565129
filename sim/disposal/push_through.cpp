#include "sim/disposal/push_through.h"

#include <algorithm>

#include "sim/disposal/charge.h"

namespace eod::sim {

MotionSet PushThrough::BlockedByMovables(std::span<const CastSegment> segments,
                                         const Response& response,
                                         std::span<const int> movable_of_object) const {
  MotionSet by_others = SetOf(kGripperOpen) | SetOf(kGripperClose);
  for (size_t i = 0; i < segments.size(); ++i) {
    const bool yields = MovableOf(movable_of_object, segments[i].hit.object) >= 0;
    if (!yields) by_others |= response.contacts[i].blocks;
  }
  return response.blocked & ~by_others;
}

MotionSet PushThrough::Update(const MotionDemand& demand, std::span<const CastSegment> segments,
                              const Response& response, std::span<const int> movable_of_object,
                              double dt_s) {
  const MotionSet pushed =
      BlockedByMovables(segments, response, movable_of_object) & demand.commanded;
  MotionSet let_through = 0;
  for (int motion = 0; motion < kMotionCount; ++motion) {
    int& steps = blocked_steps_[motion];
    if (!Contains(pushed, motion)) {
      steps = 0;
      continue;
    }
    // The step that raises the alarm counts nothing yet: the operator cannot have known.
    if (steps * dt_s > rules_.push_through) let_through |= SetOf(motion);
    ++steps;
  }
  return let_through;
}

double PushThrough::RateOf(int motion, int speed_range) const {
  if (motion != kDriveForward && motion != kDriveReverse) return rules_.push_share;
  const double rated = RatedSpeed(robot_, motion, speed_range);
  return rated > 0 ? std::min(1.0, robot_.drive_speed[0] / rated) : 0;
}

}  // namespace eod::sim
