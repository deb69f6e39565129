#pragma once

#include <cstdint>

#include "sim/geometry/pose.h"
#include "sim/radio/cable.h"
#include "sim/radio/sight_line.h"
#include "sim/robot/robot_state.h"
#include "sim/rules/link_rules.h"
#include "sim/scenario/control_link_spec.h"

namespace eod::sim {

/// Quality of a radio link, 1 at the base to 0: it falls evenly to 0 at `range` in the line of
/// sight, and each of `walls` in the way takes its share of what is left. Distance in [m].
double RadioQuality(const ControlLinkSpec& spec, double distance, int walls);

/// Chance that a message gets lost for want of quality: 0 down to `drop_below`, from there evenly
/// up to 1 at quality 0.
double DropChance(const LinkRules& rules, double quality);

/// How robot and operator hang together: by radio over distance and through walls, by a cable of
/// some length, or as if neither were there. Pure; no allocation.
class ControlLink {
 public:
  ControlLink(const ControlLinkSpec& spec, const LinkRules& rules, double dt_s);

  /// The robot stands at its start in a module. `base`: whether the scenario's base is in it.
  void Reset(const World& world, uint32_t class_bit, const RobotState& state, bool has_base);
  /// Once a step, after the motion. It looks along the lines of sight now and then alone.
  void Advance(const World& world, const RobotState& state, bool silent, bool snagged);

  double quality() const { return quality_; }    ///< 0..1
  double drop_chance() const { return drop_; }   ///< of a message, 0..1
  double distance() const { return distance_; }  ///< [m] from the base's antenna to the robot's
  int walls() const { return walls_; }           ///< between them, when it last looked
  const Cable& cable() const { return cable_; }
  /// Drive motions that a taut cable forbids: those that take the robot farther out.
  MotionSet ForbiddenMotions(const RobotState& state) const;
  /// Casts so far, for tests of their cost.
  const CastCounters& work() const { return sight_.work(); }

 private:
  Eigen::Vector3d Antenna(const RobotState& state) const;
  Eigen::Vector3d Reel(const RobotState& state) const;
  void Look(const World& world, const RobotState& state);

  ControlLinkSpec spec_;
  LinkRules rules_;
  int steps_between_looks_;
  int steps_ = 0;  ///< since the last look
  SightLine sight_;
  Cable cable_;
  Eigen::Vector3d base_ = Eigen::Vector3d::Zero();  ///< antenna [m] in the module's frame
  double quality_ = 1;
  double drop_ = 0;
  double distance_ = 0;
  int walls_ = 0;
};

}  // namespace eod::sim
