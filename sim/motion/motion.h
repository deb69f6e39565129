#pragma once

#include <array>

#include "sim/robot/robot_model.h"

namespace eod::sim {

/// Motions that may act in a step, with their signed effect resolved. All in SI and radians.
struct MotionDemand {
  std::array<double, kMotionCount> rate{};  ///< 0..1 share of the rated speed; opposites never both
  MotionSet commanded = 0;                  ///< motions with rate > 0
  int speed_range = 1;                      ///< 0 creep, 1 low, 2 high
};

/// Rated speed of a motion at rate 1: [m/s] for drive and J7, [rad/s] otherwise.
double RatedSpeed(const RobotModel& robot, int motion, int speed_range);

/// Velocity that motion `motion` alone gives to the point `p_M` carried by `link`, at `rate`; in the
/// module's local frame [m/s]. `X_ML` are the link poses of the current state.
Eigen::Vector3d PointVelocity(const RobotModel& robot, const RobotState& state,
                              std::span<const Eigen::Isometry3d> X_ML, int link,
                              const Eigen::Vector3d& p_M, int motion, double speed);

/// State after `dt` under `demand`: chassis by Eq. 3, joints by Eq. 4 (clamped to their limits),
/// hands by Eq. 5, wrapped rotation by Eq. 7. The ground is not looked at: TRIPOD sets height and
/// attitude afterwards.
RobotState Advance(const RobotModel& robot, const RobotState& state, const MotionDemand& demand,
                   double dt_s);

}  // namespace eod::sim
