#pragma once

#include <cstdint>
#include <vector>

#include "sim/segments/segment.h"

namespace eod::claims {

/// What the robot's 63 short lines cost in one scene of isector_bench.
struct SceneCost {
  int64_t triangles = 0;
  double path_density = 0;  ///< triangles a m2 near the path; it grows with the scene
  int frames = 0;
  sim::CastCounters drive;       ///< sums over all frames
  std::vector<double> round_ns;  ///< ns a segment, one number a round; empty if not timed
};

/// Builds the scene, casts once to count and to warm up, then `rounds` times against the clock.
/// Throws std::invalid_argument for fewer than 10000 triangles.
SceneCost MeasureSceneCost(int64_t triangles, int frames, int rounds);

}  // namespace eod::claims
