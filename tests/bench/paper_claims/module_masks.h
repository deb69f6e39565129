#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/robot/robot_model.h"
#include "sim/segments/segment.h"
#include "sim/world/world_model.h"

namespace eod::claims {

/// Work of one drive in a world of five modules, with and without module masks.
struct MaskCount {
  std::string layout;     ///< "one_place", "side_by_side"
  std::string traversal;  ///< "every_polygon", "block_tree"
  sim::CastCounters masked, unmasked;
  bool same_answers = true;  ///< as `block_tree` with masks: the range of every segment, exactly
};

struct MaskCounts {
  int64_t triangles_each = 0;  ///< a module
  int frames = 0;              ///< of the drive
  double spacing_m = 0;        ///< between neighbours, side by side
  std::vector<MaskCount> counts;
};

/// Drives the flat module of `world` as shipped, forward into its wall, and casts from `frames`
/// places of that drive in a world of five copies of that module, each with a module bit of its
/// own: all in one place, and side by side in an area of 3000 m.
MaskCounts CountWithMasks(const sim::RobotModel& robot, const sim::WorldModel& world, int frames);

}  // namespace eod::claims
