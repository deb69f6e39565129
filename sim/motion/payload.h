#pragma once

#include <span>

#include "sim/motion/motion.h"

namespace eod::sim {

/// What the arm can lift where its hand is: a moment about the shoulder that full stretch uses up,
/// never more than the folded arm bears.
class Payload {
 public:
  /// `robot` must outlive it. Without <eod:payload> there is no limit.
  explicit Payload(const RobotModel& robot);

  /// [kg] at the reach in `X_ML`: horizontal, from the big arm's axis to the crossbeam. Infinite
  /// without a limit.
  double Limit(std::span<const Eigen::Isometry3d> X_ML) const;

  /// Arm motions among `wanted` that would take `load_kg` farther out than it may be.
  MotionSet Forbidden(const RobotState& state, const MotionDemand& wanted, double load_kg,
                      double dt_s);

 private:
  double Reach(std::span<const Eigen::Isometry3d> X_ML) const;

  const RobotModel& robot_;
  int shoulder_;
  int hand_;
  double full_reach_ = 0;  ///< [m]
  std::vector<Eigen::Isometry3d> X_ML_;
};

}  // namespace eod::sim
