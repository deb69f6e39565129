#pragma once

#include <vector>

#include "sim/segments/level_ground.h"
#include "sim/segments/segment.h"
#include "sim/segments/surroundings.h"

namespace eod::sim {

/// One hit of a query with HitRule::kAll.
struct ListedHit {
  int query = 0;  ///< index in the list that was cast
  SegmentHit hit;
};

/// What one reader of a world keeps from cast to cast: a robot, a thread, a test. Worlds are read
/// by many threads at once, each with a memory of its own. Memory only grows: no allocation once a
/// reader has seen its largest cast.
struct CastMemory {
  CastCounters counters;
  std::vector<ListedHit> all;  ///< of the last cast, by query, then by range
  Surroundings surroundings;
  LevelGround level;
};

}  // namespace eod::sim
