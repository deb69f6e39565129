#include "batch/ground.h"

#include <utility>

#include "batch/fingerprint.h"

namespace eod::batch {

Ground LoadGround(const GroundFiles& files) {
  Ground ground;
  ground.rig.bridge.dbc_file = files.dbc;
  ground.rig.bridge.map_file = files.map;
  ground.rig.sim.simulator.exercise = sim::LoadRules(files.rules);
  ground.robot = sim::LoadRobot(files.robot);
  ground.worlds = SplitByModule(sim::LoadWorld(files.world));
  Fingerprint box;
  box.AddFile(files.dbc);
  box.AddFile(files.map);
  ground.inputs.world = FingerprintOfSdf(files.world);
  ground.inputs.robot = FingerprintOfSdf(files.robot);
  ground.inputs.rules = FingerprintOfFile(files.rules);
  ground.inputs.box = box.text();
  ground.inputs.program = FingerprintOfFile(files.program);
  return ground;
}

std::vector<sim::WorldModel> SplitByModule(sim::WorldModel world) {
  std::vector<sim::WorldModel> worlds;
  for (sim::ModuleModel& module : world.modules) {
    sim::WorldModel own;
    own.file = world.file;
    own.atmosphere = world.atmosphere;
    own.modules.push_back(std::move(module));
    worlds.push_back(std::move(own));
  }
  return worlds;
}

}  // namespace eod::batch
