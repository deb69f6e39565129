#include "sim/operator_command.h"

#include <algorithm>

namespace eod::sim {

Wish WishOf(const OperatorCommand& command, TimePoint now, Duration timeout) {
  Wish wish;
  if (!command.motion_permitted && !command.safe_stop) return wish;

  MotionSet asked = 0;
  for (int motion = 0; motion < kMotionCount; ++motion) {
    if (command.motion_rate[motion] > 0) asked |= SetOf(motion);
  }
  const bool known_range = command.speed_range >= 0 && command.speed_range <= 2;
  if (now - command.stamp >= timeout || !known_range) {
    wish.refused = asked;
    wish.reason = kReasonLinkLoss;
    return wish;
  }

  wish.demand.speed_range = command.speed_range;
  for (int motion = 0; motion < kMotionCount; ++motion) {
    if (!Contains(asked, motion)) continue;
    if (Contains(asked, motion ^ 1)) {
      wish.refused |= SetOf(motion);
      wish.reason = kReasonConflict;
      continue;
    }
    wish.demand.rate[motion] = std::min(command.motion_rate[motion], 1.0);
    wish.demand.commanded |= SetOf(motion);
  }
  return wish;
}

}  // namespace eod::sim
