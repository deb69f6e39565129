#include <benchmark/benchmark.h>

#include "firmware_emu/script.h"
#include "lockstep/rig.h"
#include "sim/scenario/scenario.h"

namespace {

using namespace std::chrono_literals;

/// A mission with box, bridge and simulator, cameras off: how much faster than real time.
void Drive(benchmark::State& state, const char* script, const char* scenario_name) {
  const std::filesystem::path data = EOD_DATA_DIR;
  const auto robot = eod::sim::LoadRobot(data / "sim/robots/eod_robot.sdf");
  const auto world = eod::sim::LoadWorld(data / "sim/worlds/training_ground.sdf");
  const auto scenario = eod::sim::LoadScenario(data / "sim/scenarios" / scenario_name);
  eod::lockstep::RigConfig config;
  config.bridge.dbc_file = data / "dbc/control_box.dbc";
  config.bridge.map_file = data / "dbc/control_box.map.toml";
  config.sim.simulator.exercise = eod::sim::LoadRules(data / "sim/rules/eod_rules.toml");
  eod::box::BoxNodeConfig box;
  box.dbc_file = config.bridge.dbc_file;
  box.map_file = config.bridge.map_file;
  box.script = eod::box::LoadScript(data / "firmware_emu/scripts" / script);
  double virtual_s = 0;
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    eod::lockstep::LockStepRig rig(config, robot, world, scenario);
    const eod::box::BoxNode& node = rig.AddBox(box);
    state.ResumeTiming();
    rig.RunUntil([&node] { return node.is_script_done(); }, 200s);
    virtual_s += eod::ToSeconds(rig.now() - config.start);
    if (rig.simulator().last().task.state != eod::sim::MissionState::kSuccess) {
      state.SkipWithError("the mission did not succeed");
      break;
    }
  }
  // Simulated seconds in a second of the processor.
  state.counters["real_time_x"] = benchmark::Counter(virtual_s, benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(Drive, FirstDrive, "first_drive.boxscript", "flat_first_drive.toml")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Drive, ChargeIntoTheCan, "bomb_ground.boxscript", "bomb_ground_m.toml")
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
