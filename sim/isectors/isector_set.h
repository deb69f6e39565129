#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "sim/robot/robot_model.h"
#include "sim/world/world.h"

namespace eod::sim {

/// One segment as it was cast in the last step.
struct CastSegment {
  int isector = 0;  ///< index in RobotModel::isectors
  int segment = 0;  ///< index in IsectorSpec::segments
  SegmentQuery query;
  SegmentHit hit;
};

/// Height and attitude of the ground under the robot, by TRIPOD.
struct GroundFix {
  int legs = 0;          ///< how many legs met ground, 0..3
  double height = 0;     ///< [m] z of the plane under the tripod's origin; legs >= 1
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of the plane, z > 0; legs == 3
  double mean_offset = 0;  ///< [m] mean of (hit z - leg's own foot z), for 1 or 2 legs
};

/// The robot's isectors: which are active, where their lines are, and what those met.
///
/// Dynamic loading (2.5 of the design): an isector, and a segment of it, is cast only while one of its
/// motions is commanded. TRIPOD is always cast: the robot stands on it.
class IsectorSet {
 public:
  IsectorSet(const RobotModel& model, uint32_t module_bit);

  /// Casts all active segments from the current pose. `X_ML`: pose of every link in the module's
  /// local frame. No allocation after the first call.
  void Cast(const World& world, std::span<const Eigen::Isometry3d> X_ML, MotionSet commanded);

  /// All segments cast in the last call, in the order of the robot file.
  std::span<const CastSegment> segments() const { return segments_; }
  /// Plane through the feet of TRIPOD, from the last call.
  const GroundFix& ground() const { return ground_; }
  const CastCounters& counters() const { return counters_; }

 private:
  void FixGround(std::span<const Eigen::Isometry3d> X_ML);

  const RobotModel& model_;
  uint32_t module_bit_;
  std::vector<CastSegment> segments_;
  std::vector<SegmentQuery> queries_;
  std::vector<SegmentHit> hits_;
  GroundFix ground_;
  CastCounters counters_;
};

}  // namespace eod::sim
