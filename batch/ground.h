#pragma once

#include <filesystem>
#include <vector>

#include "batch/run_record.h"
#include "lockstep/rig.h"

namespace eod::batch {

/// The files that all runs of a batch share.
struct GroundFiles {
  std::filesystem::path world, robot, rules, dbc, map;
  std::filesystem::path program;  ///< what simulates: another one makes other runs
};

/// What all runs of a batch share, read once and only looked at afterwards, by any thread.
struct Ground {
  lockstep::RigConfig rig;
  sim::RobotModel robot;
  std::vector<sim::WorldModel> worlds;  ///< of one module each
  RunInputs inputs;                     ///< without scenario and script
};

/// Throws what the loaders throw.
Ground LoadGround(const GroundFiles& files);

/// A world for each module of `world`, with that module alone. A rig builds everything that its
/// menu can choose; a run stays in the module of its scenario and need not pay for the others.
std::vector<sim::WorldModel> SplitByModule(sim::WorldModel world);

}  // namespace eod::batch
