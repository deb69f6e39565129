#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <Eigen/Core>

#include "sim/geometry/object_class.h"

namespace eod::sim {

enum class HitRule : uint8_t { kNearest, kHighest };
enum class FaceRule : uint8_t { kTwoSided, kFrontOnly };

/// A line segment to intersect, in the module's local frame.
struct SegmentQuery {
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitY();  ///< unit
  double length = 0;                                     ///< [m]
  uint32_t class_mask = 0;  ///< tests objects that `Accepts(class_mask, object class)`
  HitRule hit_rule = HitRule::kNearest;
  FaceRule face_rule = FaceRule::kTwoSided;
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
  int triangle = -1;  ///< within the world; -1 for analytic shapes
};

/// Work done, for the tests of masks and dynamic loading.
struct CastCounters {
  uint64_t segments = 0;
  uint64_t candidates = 0;  ///< triangles or shapes offered to the exact test
};

/// What segments can meet in one module: the seam behind which the engine stands.
class World {
 public:
  virtual ~World() = default;
  /// Answers `queries[i]` in `hits[i]`. Thread-safe for reading, no allocation.
  virtual void Cast(std::span<const SegmentQuery> queries, std::span<SegmentHit> hits,
                    CastCounters& counters) const = 0;
  /// Name of an object, "" if out of range.
  virtual const std::string& ObjectName(int object) const = 0;
};

}  // namespace eod::sim
