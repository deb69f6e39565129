#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "sim/isectors/isector_batch.h"
#include "sim/isectors/isector_rules.h"
#include "sim/isectors/tripod_reading.h"
#include "sim/robot/robot_model.h"

namespace eod::sim {

/// One segment as it was cast in the last step.
struct CastSegment {
  int isector = 0;  ///< index in RobotModel::isectors
  int segment = 0;  ///< index in IsectorSpec::segments
  SegmentQuery query;
  SegmentHit hit;
};

/// Which isectors there are: those of the source paper, TRIPOD and LOS; or also the guards of
/// chassis sides and the hands' look up and down, which close the gaps of that set.
enum class Coverage : uint8_t { kPaper, kExtended };

/// The robot's isectors: which are active, where their segments are, and what those met.
///
/// Dynamic loading (as the robot file's `motions` say): an isector, and a segment of it, is cast
/// only while one of its motions is commanded. TRIPOD is always cast: the robot stands on it; so is
/// LOS_FRONT, for the clearance ahead.
class IsectorSet {
 public:
  /// `model` must outlive the set and keep its isectors.
  IsectorSet(const RobotModel& model, uint32_t module_bit, Coverage coverage = Coverage::kExtended,
             const IsectorRules& rules = {});

  /// Casts all active segments from the current pose, for `step` (0 or more). `X_ML`: pose of every
  /// link in the module's local frame. No allocation after the first call.
  void Cast(const World& world, std::span<const Eigen::Isometry3d> X_ML, MotionSet commanded,
            int64_t step);
  /// The same for the step after the last one, for who does not count steps.
  void Cast(const World& world, std::span<const Eigen::Isometry3d> X_ML, MotionSet commanded) {
    Cast(world, X_ML, commanded, step_ + 1);
  }

  /// From now on, segments that are live for these motions alone are not cast: those of flippers
  /// that bear look for a ground that they stand on.
  void Silence(MotionSet motions) { silenced_ = motions; }

  /// Takes over the segments of an isector of the model, which have changed; as many as before. No
  /// allocation. Throws std::out_of_range for one that is not there, and as Isector::SetSegment.
  void Reload(int isector);

  /// The step of the last call; Isector::kNever before the first.
  int64_t step() const { return step_; }
  /// All segments cast in the last call, in the order of the robot file.
  std::span<const CastSegment> segments() const { return segments_; }
  /// An isector by its index in RobotModel::isectors, to be read for a step. Reading one that was
  /// not active then throws StaleReading.
  const Isector& isector(int index) const { return isectors_.at(index); }
  /// Plane through the feet of TRIPOD, from the last call; no legs if the robot has none.
  const GroundFix& ground() const { return ground_; }
  /// Work of the last call.
  const CastCounters& counters() const { return batch_.counters(); }

 private:
  void Place(int index, std::span<const Eigen::Isometry3d> X_ML, MotionSet commanded);

  const RobotModel& model_;
  Coverage coverage_;
  IsectorRules rules_;
  int tripod_ = -1;  ///< index of the robot's TRIPOD
  MotionSet silenced_ = 0;
  std::vector<Isector> isectors_;  ///< one for each in the model
  IsectorBatch batch_;
  std::vector<CastSegment> segments_;
  GroundFix ground_;
  int64_t step_ = Isector::kNever;
};

}  // namespace eod::sim
