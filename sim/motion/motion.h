#pragma once

#include <array>
#include <span>

#include "sim/robot/robot_model.h"

namespace eod::sim {

/// Motions that may act in a step, with their signed effect resolved. All in SI and radians.
struct MotionDemand {
  std::array<double, kMotionCount> rate{};  ///< 0..1 share of the rated speed; opposites never both
  MotionSet commanded = 0;                  ///< motions with rate > 0
  int speed_range = 1;                      ///< 0 creep, 1 low, 2 high
  bool left_hand_stopped = false;           ///< dL = 0 of Eq. 5: the other hand moves on
  bool right_hand_stopped = false;          ///< dR = 0
};

/// The joint that a motion moves, and to which side.
struct JointMotion {
  int joint = -1;   ///< JointId; -1 for the four drive motions
  double sign = 0;  ///< +1 if the joint's coordinate grows
};
JointMotion JointOf(const RobotModel& robot, int motion);

/// A revolute joint whose limits span a full turn has no stop: it wraps (Eq. 7).
bool WrapsAround(const RobotModel& robot, int joint);

/// Rated speed of a motion at rate 1: [m/s] for drive and J7, [rad/s] otherwise.
double RatedSpeed(const RobotModel& robot, int motion, int speed_range);

/// Velocity that `motion` alone, at `speed` (as RatedSpeed has it), gives to the point `p_M`
/// carried by `link`; in the module's local frame [m/s]. `X_ML` are the link poses of `state`.
Eigen::Vector3d PointVelocity(const RobotModel& robot, const RobotState& state,
                              std::span<const Eigen::Isometry3d> X_ML, int link,
                              const Eigen::Vector3d& p_M, int motion, double speed);

/// State after `dt` under `demand`: chassis by Eq. 3, joints by Eq. 4 (clamped to their limits),
/// hands by Eq. 5, wrapped rotation by Eq. 7. The ground is not looked at: TRIPOD sets height and
/// attitude afterwards.
RobotState Advance(const RobotModel& robot, const RobotState& state, const MotionDemand& demand,
                   double dt_s);

/// Joints that stand on a limit: bit j is joint j. A joint that wraps never does.
uint32_t LimitFlags(const RobotModel& robot, const RobotState& state);

/// Motions that would push a joint beyond the limit it stands on. J7 counts only with both hands
/// there.
MotionSet LimitedMotions(const RobotModel& robot, const RobotState& state);

}  // namespace eod::sim
