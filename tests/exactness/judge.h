#pragma once

#include <cstdint>
#include <span>

#include "sim/segments/cast_memory.h"
#include "tests/exactness/reference.h"

namespace eod::sim {

/// What the engine's answers were worth.
struct Verdict {
  uint64_t segments = 0;
  uint64_t refused = 0;    ///< of those: what is no segment
  uint64_t hits = 0;       ///< segments that the reference has meet something
  uint64_t missed = 0;     ///< the reference has a hit that the engine does not, or a better one
  uint64_t extra = 0;      ///< the engine has a hit that the reference does not
  uint64_t different = 0;  ///< answers that differ between the instruction sets
  double worst_error = 0;  ///< [m] between a hit and the reference's

  void Add(const Verdict& other);
  bool ok() const;  ///< nothing missed, extra or different, error below 5 um
};

/// Compares the answer to one segment with all that the reference met, sorted by range. `listed`
/// are the engine's hits for a query of HitRule::kAll.
void Judge(const SegmentQuery& query, const SegmentHit& hit, std::span<const ListedHit> listed,
           std::span<const ReferenceHit> expected, Verdict& verdict);

}  // namespace eod::sim
