#pragma once

#include <array>
#include <string>
#include <vector>

#include "sim/isectors/isector_set.h"

namespace eod::claims {

/// Segments that are cast while exactly one motion is commanded.
struct LoadedSegments {
  int always = 0;  ///< TRIPOD and LOS_FRONT, whatever is commanded
  int loaded = 0;  ///< by the motion itself
};

struct LoadingCount {
  sim::Coverage coverage = sim::Coverage::kPaper;
  int all = 0;         ///< segments cast without dynamic loading, in every step
  int all_always = 0;  ///< of those: of the isectors that are always cast anyway
  std::array<LoadedSegments, sim::kMotionCount> motions;
};

/// Casts the robot's isectors with dynamic loading, each motion alone, and without.
LoadingCount CountLoaded(const sim::RobotModel& robot, sim::Coverage coverage);

/// The source paper's set alone, TRIPOD and the seven BUMPs, by whole isectors: one is loaded with
/// all its lines or not at all, TRIPOD only while the chassis or a flipper moves.
struct WholeCount {
  int all = 0;
  std::array<int, sim::kMotionCount> motions{};
};
WholeCount CountWholeIsectors(const sim::RobotModel& robot);

}  // namespace eod::claims
