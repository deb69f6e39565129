#pragma once

#include <array>
#include <span>

#include "sim/response/response.h"
#include "sim/rules/disposal_rules.h"

namespace eod::sim {

/// "Continue pushing after contact" (3.4): a motion that only movable things stop goes on, slowly,
/// when it is commanded long enough after the alarm: cartons slide, charges topple.
class PushThrough {
 public:
  /// `robot` must outlive it.
  PushThrough(const RobotModel& robot, const ChargeRules& rules) : robot_(robot), rules_(rules) {}
  void Reset() { blocked_steps_ = {}; }

  /// Judges one step; `response` is the answer to `demand` on `segments`. Returns the blocked
  /// motions that may go on. The gripper's never do: squeezing has a rule of its own.
  MotionSet Update(const MotionDemand& demand, std::span<const CastSegment> segments,
                   const Response& response, std::span<const int> movable_of_object, double dt_s);

  /// Largest rate, 0..1, at which a motion of that set may go on: creep, or a share of a joint's
  /// speed.
  double RateOf(int motion, int speed_range) const;

 private:
  MotionSet BlockedByMovables(std::span<const CastSegment> segments, const Response& response,
                              std::span<const int> movable_of_object) const;

  const RobotModel& robot_;
  ChargeRules rules_;
  std::array<int, kMotionCount> blocked_steps_{};
};

}  // namespace eod::sim
