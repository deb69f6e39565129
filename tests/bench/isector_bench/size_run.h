#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/bench/isector_bench/run_options.h"
#include "tests/bench/isector_bench/verdict.h"

namespace eod::bench {

enum class Outcome : uint8_t { kMeasured, kNotInstalled, kTooLarge, kNotAskedFor };

struct EngineResult {
  EngineSpec spec;
  Outcome outcome = Outcome::kNotAskedFor;
  double build_s = 0;
  int64_t bytes = 0;
  DriveTimes short_lines, sight_lines;  ///< sight_lines: empty if it has none
  Verdict on_path, at_edges, in_sight;

  int missed() const { return on_path.missed + at_edges.missed + in_sight.missed; }
  int extra() const { return on_path.extra + at_edges.extra + in_sight.extra; }
};

/// All engines on one scene.
struct SizeResult {
  int64_t triangles = 0;
  double terrain_density = 0, path_density = 0;  ///< triangles a m2
  Eigen::Vector2d terrain_size = Eigen::Vector2d::Zero();
  double short_hits = 0, leg_hits = 0, bump_hits = 0, sight_hits = 0;  ///< shares, 0..1
  int tried_by_brute_force = 0;  ///< answers of the reference that were checked so
  std::vector<EngineResult> engines;
};

/// Builds the scene and all engines, judges their answers, then times them: one round of each after
/// the other, in changing order, short lines first, lines of sight then.
///
/// Throws std::logic_error if the reference is not what brute force gives (checked up to 1e4).
SizeResult RunSize(const RunOptions& options, int64_t triangles);

}  // namespace eod::bench
