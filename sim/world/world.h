#pragma once

#include <optional>
#include <span>
#include <string>

#include "sim/segments/cast_memory.h"
#include "sim/segments/segment.h"

namespace eod::sim {

/// What segments can meet in one module: the seam behind which the engine stands.
class World {
 public:
  virtual ~World() = default;
  /// Answers `queries[i]` in `hits[i]`; both have one length. Thread-safe for reading, with one
  /// `memory` a thread. No allocation once `memory` has grown.
  virtual void Cast(std::span<const SegmentQuery> queries, std::span<SegmentHit> hits,
                    CastMemory& memory) const = 0;
  /// z [m] of the ground in `box` (module's local frame), where one level plane that looks up is
  /// all that lines with `class_mask` can meet there, and reaches across all of it: a vertical line
  /// within the box meets it at exactly that height, unless it ends before. Nothing: it is not so,
  /// or not known.
  virtual std::optional<double> LevelGroundIn(const Eigen::AlignedBox3d& box, uint32_t class_mask,
                                              CastMemory& memory) const {
    static_cast<void>(box), static_cast<void>(class_mask), static_cast<void>(memory);
    return {};
  }
  /// Name of an object, "" if out of range.
  virtual const std::string& ObjectName(int object) const = 0;
};

}  // namespace eod::sim
