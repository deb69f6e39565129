#pragma once

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
  /// Name of an object, "" if out of range.
  virtual const std::string& ObjectName(int object) const = 0;
};

}  // namespace eod::sim
