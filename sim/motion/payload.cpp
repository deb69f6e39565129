#include "sim/motion/payload.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace eod::sim {
namespace {

constexpr MotionSet kArmMotions = SetOf(kBigArmUp) | SetOf(kBigArmDown) | SetOf(kSmallArmUp) |
                                  SetOf(kSmallArmDown) | SetOf(kWristUp) | SetOf(kWristDown);

}  // namespace

Payload::Payload(const RobotModel& robot)
    : robot_(robot), shoulder_(FindLink(robot, "big_arm")), hand_(FindLink(robot, "crossbeam")) {
  RobotState stretched = HomeState(robot);
  stretched.joint[kBigArm] = 0;
  stretched.joint[kSmallArm] = std::numbers::pi;
  stretched.joint[kWrist] = 0;
  LinkPoses(robot, stretched, X_ML_);
  full_reach_ = Reach(X_ML_);
}

double Payload::Reach(std::span<const Eigen::Isometry3d> X_ML) const {
  if (shoulder_ < 0 || hand_ < 0) return 0;
  const Eigen::Vector3d arm = X_ML[hand_].translation() - X_ML[shoulder_].translation();
  return std::hypot(arm.x(), arm.y());
}

double Payload::Limit(std::span<const Eigen::Isometry3d> X_ML) const {
  const PayloadSpec& spec = robot_.payload;
  if (spec.folded <= 0) return std::numeric_limits<double>::infinity();
  const double reach = Reach(X_ML);
  const double by_moment = reach > 0 ? spec.stretched * full_reach_ / reach : spec.folded;
  return std::min(by_moment, spec.folded);
}

MotionSet Payload::Forbidden(const RobotState& state, const MotionDemand& wanted, double load_kg,
                             double dt_s) {
  MotionSet forbidden = 0;
  const MotionSet asked = wanted.commanded & kArmMotions;
  if (load_kg <= 0 || asked == 0) return forbidden;
  LinkPoses(robot_, state, X_ML_);
  const double now = Limit(X_ML_);
  for (int motion = kBigArmUp; motion <= kWristDown; ++motion) {
    if (!Contains(asked, motion)) continue;
    MotionDemand alone;
    alone.rate[motion] = wanted.rate[motion];
    alone.commanded = SetOf(motion);
    LinkPoses(robot_, Advance(robot_, state, alone, dt_s), X_ML_);
    const double then = Limit(X_ML_);
    if (then < load_kg && then < now) forbidden |= SetOf(motion);
  }
  return forbidden;
}

}  // namespace eod::sim
