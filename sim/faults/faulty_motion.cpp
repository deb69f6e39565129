#include "sim/faults/faulty_motion.h"

#include <cmath>

namespace eod::sim {
namespace {

double SignedRate(const MotionDemand& demand, int positive) {
  return demand.rate[positive] - demand.rate[positive ^ 1];
}

void SetRate(MotionDemand& demand, int positive, double rate) {
  const int motion = rate > 0 ? positive : positive ^ 1;
  demand.rate[motion] = std::abs(rate);
  demand.rate[motion ^ 1] = 0;
  demand.commanded &= ~(SetOf(motion) | SetOf(motion ^ 1));
  if (rate != 0) demand.commanded |= SetOf(motion);
}

void PullAside(const RobotModel& robot, const ActiveFaults& faults, MotionDemand& demand) {
  const double forward = robot.drive_speed[demand.speed_range];
  const double v = SignedRate(demand, kDriveForward) * forward;
  const double w = SignedRate(demand, kTurnLeft) * robot.turn_rate;
  const double left = faults.left_track * (v - w * robot.track / 2);
  const double right = faults.right_track * (v + w * robot.track / 2);
  SetRate(demand, kDriveForward, (left + right) / 2 / forward);
  SetRate(demand, kTurnLeft, (right - left) / robot.track / robot.turn_rate);
}

}  // namespace

MotionDemand FaultyMotion(const RobotModel& robot, const ActiveFaults& faults,
                          const MotionDemand& moving) {
  MotionDemand demand = moving;
  for (int j = 0; j < kJointCount; ++j) {
    const JointSpec& joint = robot.joints[j];
    const double share = (faults.stuck_joints >> j & 1U) != 0 ? 0 : faults.joint_share[j];
    const double drift = faults.joint_drift[j] / joint.rate;
    if (share == 1 && drift == 0) continue;
    SetRate(demand, joint.positive_motion,
            SignedRate(demand, joint.positive_motion) * share + drift);
  }
  if (faults.left_track != 1 || faults.right_track != 1) PullAside(robot, faults, demand);
  return demand;
}

}  // namespace eod::sim
