#include "sim/motion/drives.h"

#include <algorithm>
#include <cmath>

namespace eod::sim {

Drives::Drives(const RobotModel& robot) : robot_(robot) {
  positive_[0] = kDriveForward;
  positive_[1] = kTurnLeft;
  for (int j = 0; j < kJointCount; ++j) positive_[2 + j] = robot.joints[j].positive_motion;
}

MotionDemand Drives::Follow(const MotionDemand& wanted, double dt_s, bool brakes) {
  MotionDemand moving = wanted;
  moving.rate = {};
  moving.commanded = 0;
  for (int axis = 0; axis < kAxes; ++axis) {
    const int positive = positive_[axis], negative = positive ^ 1;
    const double rated = Rated(axis, wanted.speed_range);
    const double acceleration = axis == 0   ? robot_.drive_acceleration
                                : axis == 1 ? robot_.turn_acceleration
                                            : robot_.joints[axis - 2].acceleration;
    double& rate = rate_[axis];
    rate *= Rated(axis, speed_range_) / rated;
    const double target = wanted.rate[positive] - wanted.rate[negative];
    const double most = acceleration * dt_s / rated;
    const bool slows = target * rate >= 0 && std::abs(target) < std::abs(rate);
    rate = brakes && slows ? target : std::clamp(target, rate - most, rate + most);
    if (rate == 0) continue;
    const int motion = rate > 0 ? positive : negative;
    moving.rate[motion] = std::abs(rate);
    moving.commanded |= SetOf(motion);
  }
  speed_range_ = wanted.speed_range;
  return moving;
}

double Drives::Rated(int axis, int speed_range) const {
  return axis == 0   ? robot_.drive_speed[speed_range]
         : axis == 1 ? robot_.turn_rate
                     : robot_.joints[axis - 2].rate;
}

void Drives::Halt(MotionSet motions) {
  for (int axis = 0; axis < kAxes; ++axis) {
    const int motion = rate_[axis] > 0 ? positive_[axis] : positive_[axis] ^ 1;
    if (Contains(motions, motion)) rate_[axis] = 0;
  }
}

}  // namespace eod::sim
