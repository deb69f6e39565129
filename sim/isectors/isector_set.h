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
  int legs = 0;  ///< how many legs met ground, 0..3
  /// [m] z of the plane under the tripod's origin; with 1 or 2 legs its z moved by mean_offset.
  double height = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of the plane, z > 0; legs == 3
  /// [m] mean of (hit z - z of the robot's own plane at that leg); legs >= 1
  double mean_offset = 0;
};

/// Which isectors there are: those of the source paper, TRIPOD and LOS; or also the guards of
/// chassis sides and the hands' look up and down, which close the gaps of that set.
enum class Coverage : uint8_t { kPaper, kExtended };

/// The robot's isectors: which are active, where their lines are, and what those met.
///
/// Dynamic loading (as the robot file's `motions` say): an isector, and a segment of it, is cast
/// only while one of its motions is commanded. TRIPOD is always cast: the robot stands on it; so is
/// LOS_FRONT, for the clearance ahead. Lines of TRIPOD and of height isectors turn with the heading
/// only: they stay vertical, and take their highest hit.
class IsectorSet {
 public:
  /// `model` must outlive the set.
  IsectorSet(const RobotModel& model, uint32_t module_bit, Coverage coverage = Coverage::kExtended);

  /// Casts all active segments from the current pose. `X_ML`: pose of every link in the module's
  /// local frame. No allocation after the first call.
  void Cast(const World& world, std::span<const Eigen::Isometry3d> X_ML, MotionSet commanded);

  /// All segments cast in the last call, in the order of the robot file.
  std::span<const CastSegment> segments() const { return segments_; }
  /// Plane through the feet of TRIPOD, from the last call.
  const GroundFix& ground() const { return ground_; }
  /// Work of the last call.
  const CastCounters& counters() const { return memory_.counters; }

 private:
  bool IsActive(const IsectorSpec& isector, MotionSet commanded) const;
  void LoadIsector(size_t index, std::span<const Eigen::Isometry3d> X_ML, MotionSet commanded);
  void FixGround(std::span<const Eigen::Isometry3d> X_ML);

  const RobotModel& model_;
  uint32_t module_bit_;
  Coverage coverage_;
  std::vector<CastSegment> segments_;
  std::vector<SegmentQuery> queries_;
  std::vector<SegmentHit> hits_;
  GroundFix ground_;
  CastMemory memory_;
};

}  // namespace eod::sim
