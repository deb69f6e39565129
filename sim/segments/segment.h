#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "sim/geometry/object_class.h"

namespace eod::sim {

/// Which of several hits answers: the one nearest to the start, the one with the largest z, or all
/// of them (`SegmentHit` is then the nearest one, `CastMemory::all` has every one).
enum class HitRule : uint8_t { kNearest, kHighest, kAll };
/// Front: the surface's normal looks against the segment's direction.
enum class FaceRule : uint8_t { kTwoSided, kFrontOnly };

/// A line segment to intersect, in the module's local frame.
struct SegmentQuery {
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitY();  ///< unit, to 1e-6
  double length = 0;                                     ///< [m] 0 or more
  uint32_t class_mask = 0;  ///< tests objects that `Accepts(class_mask, object class)`
  HitRule hit_rule = HitRule::kNearest;
  FaceRule face_rule = FaceRule::kTwoSided;
  /// Neighbours in the list with one group and one mask are culled together: the segments of one
  /// isector. Has no influence on the answers.
  uint32_t group = 0;
};

/// What a segment met. Both ends count: a hit exactly at the start has range 0. (What lies within a
/// nanometre beyond an end counts as on it, so that rounding never loses an exact touch.)
struct SegmentHit {
  bool hit = false;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< local frame
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, as the surface faces
  double range = 0;                                   ///< [m] from start, never negative
  int object = -1;                                    ///< index for `World::ObjectName`
  uint32_t object_class = 0;
  int triangle = -1;  ///< within the world, as loaded; -1 for exact shapes
};

inline constexpr double kEndTolerance = 1e-9;  ///< [m] see SegmentHit

/// Work done, for the tests of masks and dynamic loading. Sums since the memory was made.
struct CastCounters {
  uint64_t segments = 0;    ///< asked for
  uint64_t rejected = 0;    ///< of those: NaN, infinite, no unit direction or a negative length;
                            ///< answered "no hit"
  uint64_t blocks = 0;      ///< blocks of triangles that were opened (broad phase)
  uint64_t candidates = 0;  ///< triangles and shapes, each with each segment that it was offered to
  uint64_t exact = 0;       ///< of those: what the exact test had to decide
  uint64_t refills = 0;     ///< times that the surroundings were gathered anew
  bool operator==(const CastCounters&) const = default;
};

}  // namespace eod::sim
