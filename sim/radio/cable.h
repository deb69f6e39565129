#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/radio/sight_line.h"

namespace eod::sim {

/// The cable that the robot's reel pays out and winds in: taut from its fixed end round the corners
/// that the robot drove round, to the robot. Pure; no allocation.
class Cable {
 public:
  explicit Cable(double length);

  /// Lies straight from its fixed end to the robot (module's frame [m]).
  void Reset(const Eigen::Vector3d& fixed_end, const Eigen::Vector3d& robot);
  /// The robot has moved. Cheap: for every step.
  void Follow(const Eigen::Vector3d& robot) { robot_ = robot; }
  /// Looks where the cable bends now. A corner is where the robot was when it last saw the bend
  /// before it.
  void FindCorners(const World& world, SightLine& sight);
  /// No more pays out than is out now; or the reel is free again.
  void SetSnagged(bool snagged);

  /// [m] from its fixed end round the corners to the robot.
  double paid_out() const { return fixed_ + (robot_ - corners_.back()).norm(); }
  /// It holds the robot: all that can pay out is out.
  bool is_taut() const { return paid_out() >= most_; }
  /// Unit vector along which it holds the robot back, horizontal; zero at its own corner.
  Eigen::Vector2d Outwards() const;
  int corners() const { return static_cast<int>(corners_.size()) - 1; }

 private:
  static constexpr size_t kMostCorners = 64;  ///< further bends are taken as straight

  double length_;
  double most_;                           ///< [m] that may be out
  double fixed_ = 0;                      ///< [m] from the fixed end to the last corner
  std::vector<Eigen::Vector3d> corners_;  ///< the fixed end first
  Eigen::Vector3d robot_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d seen_ = Eigen::Vector3d::Zero();  ///< the robot, when it last saw the last corner
  bool snagged_ = false;
};

}  // namespace eod::sim
