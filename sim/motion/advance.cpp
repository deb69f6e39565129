#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/motion/motion.h"

namespace eod::sim {
namespace {

/// Signed speed of a pair of opposite motions: `positive` minus its neighbour.
double PairSpeed(const RobotModel& robot, const MotionDemand& demand, int positive, int negative) {
  const auto speed = [&](int motion) {
    return demand.rate[motion] * RatedSpeed(robot, motion, demand.speed_range);
  };
  return speed(positive) - speed(negative);
}

/// Wraps into (-pi, pi] (Eq. 7).
double WrapTurn(double angle) {
  const double wrapped = std::remainder(angle, 2 * std::numbers::pi);
  return wrapped <= -std::numbers::pi ? wrapped + 2 * std::numbers::pi : wrapped;
}

/// Eq. 3, with both slips of the print corrected. z is a prediction: TRIPOD has the last word.
void AdvanceChassis(const RobotModel& robot, const MotionDemand& demand, double dt_s,
                    RobotState& state) {
  const double d = PairSpeed(robot, demand, kDriveForward, kDriveReverse) * dt_s;
  const double turn = PairSpeed(robot, demand, kTurnLeft, kTurnRight) * dt_s;
  const Attitude& attitude = state.attitude;
  state.position.x() -= d * std::cos(attitude.pitch) * std::sin(attitude.heading);
  state.position.y() += d * std::cos(attitude.pitch) * std::cos(attitude.heading);
  state.position.z() += d * std::sin(attitude.pitch);
  if (turn != 0) state.attitude.heading = WrapHeading(attitude.heading + turn);
}

/// Eq. 5: the hands move apart or together, each up to its own stop. The joint is their mean, from
/// which the crossbeam follows (Eq. 6).
void AdvanceHands(const JointSpec& joint, const MotionDemand& demand, double change,
                  RobotState& state) {
  if (!demand.left_hand_stopped) {
    state.left_opening = std::clamp(state.left_opening + change, joint.lower, joint.upper);
  }
  if (!demand.right_hand_stopped) {
    state.right_opening = std::clamp(state.right_opening + change, joint.lower, joint.upper);
  }
  state.joint[kGripperOpening] = (state.left_opening + state.right_opening) / 2;
}

}  // namespace

double RatedSpeed(const RobotModel& robot, int motion, int speed_range) {
  if (motion == kDriveForward || motion == kDriveReverse) return robot.drive_speed[speed_range];
  if (motion == kTurnLeft || motion == kTurnRight) return robot.turn_rate;
  const int joint = JointOf(robot, motion).joint;
  return joint < 0 ? 0 : robot.joints[joint].rate;
}

JointMotion JointOf(const RobotModel& robot, int motion) {
  for (int j = 0; j < kJointCount; ++j) {
    if (robot.joints[j].positive_motion == motion) return {.joint = j, .sign = 1};
    if (robot.joints[j].negative_motion == motion) return {.joint = j, .sign = -1};
  }
  return {};
}

bool WrapsAround(const RobotModel& robot, int joint) {
  constexpr double kFullTurn = 2 * std::numbers::pi - 1e-6;
  return joint != kGripperOpening &&
         robot.joints[joint].upper - robot.joints[joint].lower >= kFullTurn;
}

RobotState Advance(const RobotModel& robot, const RobotState& state, const MotionDemand& demand,
                   double dt_s) {
  RobotState next = state;
  AdvanceChassis(robot, demand, dt_s, next);
  for (int j = 0; j < kJointCount; ++j) {
    const JointSpec& joint = robot.joints[j];
    const double change =
        PairSpeed(robot, demand, joint.positive_motion, joint.negative_motion) * dt_s;
    if (change == 0) continue;
    if (j == kGripperOpening) {
      AdvanceHands(joint, demand, change, next);
    } else if (WrapsAround(robot, j)) {
      next.joint[j] = WrapTurn(state.joint[j] + change);
    } else {
      next.joint[j] = std::clamp(state.joint[j] + change, joint.lower, joint.upper);
    }
  }
  return next;
}

uint32_t LimitFlags(const RobotModel& robot, const RobotState& state) {
  uint32_t flags = 0;
  for (int j = 0; j < kJointCount; ++j) {
    const JointSpec& joint = robot.joints[j];
    const bool on_limit = state.joint[j] <= joint.lower || state.joint[j] >= joint.upper;
    if (on_limit && !WrapsAround(robot, j)) flags |= 1u << j;
  }
  return flags;
}

MotionSet LimitedMotions(const RobotModel& robot, const RobotState& state) {
  MotionSet limited = 0;
  for (int j = 0; j < kJointCount; ++j) {
    if (WrapsAround(robot, j)) continue;
    const JointSpec& joint = robot.joints[j];
    if (state.joint[j] >= joint.upper) limited |= SetOf(joint.positive_motion);
    if (state.joint[j] <= joint.lower) limited |= SetOf(joint.negative_motion);
  }
  return limited;
}

}  // namespace eod::sim
