#pragma once

#include <vector>

#include "sim/world/world.h"

namespace eod::sim {

/// Looks along straight lines for what stands in the way of radio waves or a cable: static things
/// that a robot runs into, such as walls; no movables, no ground that it stands on alone.
class SightLine {
 public:
  /// Takes its memory now, and none later.
  void Reserve();

  /// The module whose things it looks for.
  void SetModule(uint32_t class_bit) { class_bit_ = class_bit; }
  /// How many walls stand between two points of the module's frame: two surfaces are one, what
  /// begins or ends inside of one counts as a whole one.
  int Walls(const World& world, const Eigen::Vector3d& from_M, const Eigen::Vector3d& to_M);
  /// Height [m] of the ground below or little above a point of the module's frame; the point's own
  /// if there is none within 5 m.
  double GroundAt(const World& world, const Eigen::Vector3d& p_M);

  /// What it has cost so far.
  const CastCounters& work() const { return memory_.counters; }

 private:
  uint32_t class_bit_ = 0;
  CastMemory memory_;
};

}  // namespace eod::sim
