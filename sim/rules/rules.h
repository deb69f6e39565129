#pragma once

#include <filesystem>

#include "sim/rules/critical_rules.h"
#include "sim/rules/disposal_rules.h"
#include "sim/rules/explosion_rules.h"
#include "sim/rules/link_rules.h"
#include "sim/rules/score_rules.h"

namespace eod::sim {

/// When the robot's tilt is told to the operator [rad].
struct TiltRules {
  double alarm = 0;     ///< tilt beyond this is an alarm
  double rollover = 0;  ///< beyond this the robot lies on its back
};

/// Tuning of the exercise: what is no property of the robot or of a world. Every number comes from
/// a data file, with its unit and source.
struct Rules {
  std::filesystem::path file;
  TiltRules tilt;
  GraspRules grasp;
  ChargeRules charge;
  VesselRules vessel;
  DisrupterRules disrupter;
  ExplosionRules explosion;
  ScoreRules score;
  CriticalRules critical;
  LinkRules link;
};

/// Reads and checks the rules. Throws std::runtime_error with one line "FILE:LINE: …".
Rules LoadRules(const std::filesystem::path& file);

}  // namespace eod::sim
