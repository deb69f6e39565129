#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "sim/segments/isector_method.h"
#include "sim/world/world.h"

namespace eod::sim {

/// A result was read that does not belong to the step it was read in.
class StaleReading : public std::logic_error {
 public:
  /// `what` is "B1" or "B1 segment 5"; `cast` is Isector::kNever if there is no result at all.
  StaleReading(const std::string& what, int64_t asked, int64_t cast);
  int64_t asked_step() const { return asked_; }
  int64_t cast_step() const { return cast_; }

 private:
  int64_t asked_;
  int64_t cast_;
};

/// A segment in the isector's own frame I: X right, Y forward, Z up, origin O.
struct IsectorSegment {
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitY();  ///< unit, to 1e-6
  double length = 0;                                     ///< [m] 0 or more
  bool enabled = true;
};

/// An intersection vector: segments carried by a pose, and what they met when they were last cast.
///
/// Needs no robot. It is cast by CastIsectors, together with others. Each reading is for a step: a
/// result of another step, of a disabled isector or a disabled segment throws StaleReading instead
/// of passing for a fresh one. Pose and rules may change at any time; results are those of the
/// last cast. Source: 1.1-1.4 of the design, after Vega's isectors.
class Isector {
 public:
  static constexpr int64_t kNever = -1;

  /// Looks for UsualClasses in any module, two-sided; ground methods take the highest hit, others
  /// the nearest. Throws std::invalid_argument that names the isector: a number of segments that
  /// the method does not have, a direction that is no unit vector, a bad length, a TRIPOD whose
  /// legs stand in one line.
  Isector(std::string name, IsectorMethod method, std::vector<IsectorSegment> segments);

  const std::string& name() const { return name_; }
  IsectorMethod method() const { return method_; }
  std::span<const IsectorSegment> segments() const { return segments_; }
  bool enabled() const { return enabled_; }
  /// Throws std::invalid_argument unless it is of `method`.
  void RequireMethod(IsectorMethod method) const;

  /// Pose of O and the axes in the module's local frame. Of its attitude, ground methods take the
  /// heading alone.
  void set_pose(const Eigen::Isometry3d& X_MI) { X_MI_ = X_MI; }
  /// Bits of object_class.h; see Accepts.
  void set_class_mask(uint32_t class_mask) { class_mask_ = class_mask; }
  void set_face_rule(FaceRule rule) { face_rule_ = rule; }
  void set_hit_rule(HitRule rule) { hit_rule_ = rule; }
  /// A disabled isector is not cast.
  void set_enabled(bool enabled) { enabled_ = enabled; }
  /// Throws std::out_of_range for a segment that is not there.
  void EnableSegment(int segment, bool enabled) { segments_.at(segment).enabled = enabled; }
  /// Throws std::out_of_range, and std::invalid_argument for a length that is negative or not
  /// finite.
  void SetLength(int segment, double metres);

  /// Another line in place of one; no allocation. Throws std::out_of_range, and
  /// std::invalid_argument for a direction or a length that cannot be.
  void SetSegment(int segment, const IsectorSegment& line);

  /// Whether it was cast in `step`, so that reading does not throw.
  bool IsFresh(int64_t step) const { return cast_step_ == step; }
  bool IsFresh(int64_t step, int segment) const { return results_.at(segment).step == step; }
  /// What a segment met: the first of AllHits with HitRule::kAll.
  const SegmentHit& Hit(int segment, int64_t step) const;
  /// All that a segment met, by range. With another rule than HitRule::kAll that is one hit, or
  /// none. Valid until the next cast.
  std::span<const SegmentHit> AllHits(int segment, int64_t step) const;
  /// The pose that it was cast from.
  const Eigen::Isometry3d& PoseOfCast(int64_t step) const;

 private:
  struct Result {
    int64_t step = kNever;
    SegmentHit hit;
    bool is_list = false;  ///< cast with HitRule::kAll
    size_t first_listed = 0;
    size_t listed = 0;
  };
  friend class IsectorBatch;
  SegmentQuery QueryOf(const IsectorSegment& segment, const Eigen::Isometry3d& X_MS) const;
  /// The frame that the segments are laid out in.
  Eigen::Isometry3d SegmentFrame() const;
  /// Opens the results of a step, before Take of each segment that is cast.
  void BeginStep(int64_t step);
  void Take(int segment, const SegmentHit& hit, std::span<const ListedHit> listed);

  std::string name_;
  IsectorMethod method_;
  std::vector<IsectorSegment> segments_;
  Eigen::Isometry3d X_MI_ = Eigen::Isometry3d::Identity();
  uint32_t class_mask_;
  FaceRule face_rule_ = FaceRule::kTwoSided;
  HitRule hit_rule_;
  bool enabled_ = true;

  int64_t cast_step_ = kNever;
  Eigen::Isometry3d X_MI_of_cast_ = Eigen::Isometry3d::Identity();
  std::vector<Result> results_;  ///< one a segment
  std::vector<SegmentHit> listed_;
};

}  // namespace eod::sim
