#pragma once

namespace eod::sim {

/// What costs points, of 100.
struct ScoreRules {
  double collision_points = 0;  ///< a collision that no step asked for
  double touch_points = 0;      ///< a charge that is touched and not grasped
  double touch_memory = 0;      ///< [s] a touch lasts until the charge was left alone so long
};

}  // namespace eod::sim
