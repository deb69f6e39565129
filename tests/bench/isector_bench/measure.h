#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tests/bench/isector_bench/engine.h"

namespace eod::bench {

/// The lines of a drive, frame after frame.
struct Drive {
  std::span<const sim::SegmentQuery> lines;
  int per_frame = 1;
  int cast = 1;  ///< of each frame the first so many lines are cast

  size_t frames() const { return lines.size() / static_cast<size_t>(per_frame); }
};

/// Times of one engine over several rounds of one drive.
struct DriveTimes {
  std::vector<double> round_us;  ///< mean of a frame, by round
  std::vector<double> frame_us;  ///< by frame, the best of all rounds
  double worst_frame_us = 0;     ///< the longest single frame, interruptions included
  int cast = 1;                  ///< lines a frame

  double best_us() const;
  double median_us() const;
  /// The slowest frame by what it takes undisturbed: its best over the rounds.
  double worst_undisturbed_us() const;
  double ns_per_line(double frame) const { return frame * 1000 / cast; }
};

/// Casts all frames once. Each frame is timed by reading the clock once at its end; what that costs
/// (see ClockCost) is part of all times.
void TimeRound(Engine& engine, const Drive& drive, DriveTimes& times);

/// The answers of one drive, in the order of its lines; lines that are not cast have none.
std::vector<sim::SegmentHit> Answers(Engine& engine, const Drive& drive);

/// What reading the clock takes [ns].
double ClockCost();

/// What a process holds in memory of its own (RssAnon of Linux), after everything free was given
/// back [bytes]. One yardstick for all: allocators of their own (Embree) are in it too.
int64_t HeldMemory();

struct Built {
  std::unique_ptr<Engine> engine;
  double seconds = 0;
  int64_t bytes = 0;  ///< growth of HeldMemory
};

Built Build(const EngineSpec& spec, const Source& source);

}  // namespace eod::bench
