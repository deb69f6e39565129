#include "sim/operator_command.h"

#include <algorithm>

namespace eod::sim {
namespace {

/// Of arm, gripper and flippers.
constexpr MotionSet kPresetMotions = (SetOf(kCameraPanLeft) - 1) & ~(SetOf(kFrontFlipperUp) - 1);

}  // namespace

MotionSet AskedMotions(const OperatorCommand& command) {
  MotionSet asked = 0;
  for (int motion = 0; motion < kMotionCount; ++motion) {
    if (command.motion_rate[motion] > 0) asked |= SetOf(motion);
  }
  return asked;
}

Wish WishOf(const OperatorCommand& command, TimePoint now, Duration timeout) {
  Wish wish;
  if (!command.motion_permitted && !command.safe_stop) return wish;

  const MotionSet asked = AskedMotions(command);
  const bool known_range = command.speed_range >= 0 && command.speed_range <= 2;
  if (now - command.stamp >= timeout || !known_range) {
    wish.refused = asked;
    wish.reason = kReasonLinkLoss;
    return wish;
  }

  wish.trusted = true;
  wish.brakes = command.safe_stop;
  wish.preset = command.motion_permitted ? command.preset : 0;
  if (wish.preset != 0 && (asked & kPresetMotions) != 0) {
    wish.refused = asked & kPresetMotions;
    wish.reason = kReasonConflict;
    wish.preset = 0;
  }
  wish.demand.speed_range = command.speed_range;
  for (int motion = 0; motion < kMotionCount; ++motion) {
    if (!Contains(asked & ~wish.refused, motion)) continue;
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

Wish WishOf(const OperatorCommand& command, const ActiveFaults& faults, TimePoint now,
            Duration timeout) {
  if (faults.field_estop) {
    Wish wish;
    wish.refused = AskedMotions(command);
    wish.reason = kReasonEstop;
    return wish;
  }
  if (faults.stuck_buttons == 0 || !command.motion_permitted) return WishOf(command, now, timeout);
  OperatorCommand pressed = command;
  for (int motion = 0; motion < kMotionCount; ++motion) {
    if (Contains(faults.stuck_buttons, motion)) pressed.motion_rate[motion] = 1;
  }
  return WishOf(pressed, now, timeout);
}

}  // namespace eod::sim
