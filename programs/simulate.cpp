#include "programs/simulate.h"

#include <cstdio>
#include <memory>
#include <vector>

#include <fmt/format.h>
#include <malloc.h>

#include "lockstep/replay.h"
#include "platform/priority.h"
#include "platform/run_main.h"
#include "platform/run_node.h"
#include "sim/mission_report.h"
#include "sim/picture_node.h"
#include "sim/placing.h"
#include "sim/scenario/catalogue.h"
#include "sim/scenario/variation.h"

namespace eod::sim {
namespace {

/// A simulator that has the missions it ran reported.
class ReportedNode {
 public:
  ReportedNode(SimNode& node, const std::filesystem::path& folder) : node_(node), report_(folder) {}

  void OnCan() {}
  void OnTick(TimePoint scheduled) {
    node_.OnTick(scheduled);
    report_.Watch(node_.simulator());
  }
  Duration tick_period() const { return node_.tick_period(); }
  void Finish() { report_.Finish(node_.simulator()); }

 private:
  SimNode& node_;
  MissionReport report_;
};

}  // namespace

namespace {

/// The exercise to begin with.
Scenario FirstExercise(const SimOptions& options) {
  return Vary(LoadScenario(options.scenario, options.scenarios), options.repetition);
}

/// What the menu can choose: what does not fit this world is told and left out.
std::vector<Scenario> Exercises(const SimOptions& options, const WorldModel& world) {
  std::vector<Scenario> catalogue = LoadCatalogue(options.scenarios);
  std::erase_if(catalogue, [&world](const Scenario& scenario) {
    try {
      CheckFits(scenario, world);
      return false;
    } catch (const std::runtime_error& error) {
      fmt::print(stderr, "not in the menu: {}\n", error.what());
      return true;
    }
  });
  return catalogue;
}

}  // namespace

void SimulateLive(const SimOptions& options, const StationOptions& station) {
  const RobotModel robot = LoadRobot(options.robot);
  const WorldModel world = LoadWorld(options.world);
  const Scenario scenario = FirstExercise(options);
  SimNodeConfig config = options.node;
  config.simulator.exercise = LoadRules(options.rules);
  config.simulator.catalogue = Exercises(options, world);
  malloc_trim(0);  // the SDFormat reader leaves tens of megabytes of free heap behind
  RunBeforeOthers();
  const SteadyClock clock;
  const auto lcm = OpenLcm(station.lcm);
  SimNode node(config, robot, world, scenario, *lcm, clock);

  PictureNode pictures(*lcm, options.node.channel_prefix);
  std::unique_ptr<CameraThread> cameras;
  if (options.cameras) {
    cameras = std::make_unique<CameraThread>(
        robot, world, options.camera,
        [&pictures](const Picture& picture) { pictures.Publish(picture); });
    node.SetSceneOutput(
        {.show = [&cameras](const auto& scene) { cameras->Show(scene); },
         .period = std::chrono::nanoseconds(static_cast<int64_t>(1e9 / options.camera.rate_hz)),
         .draw_isectors = options.camera.draw_isectors});
  }
  SayReady(station.lcm.url.empty() ? "LCM" : station.lcm.url);
  ReportedNode reported(node, options.report);
  RunNode(reported, nullptr, *lcm, clock);
  reported.Finish();
  fmt::print("{} steps, {} overruns, {} pictures\n", node.simulator().last().step, node.overruns(),
             cameras ? cameras->pictures() : 0);
}

void SimulateLog(const SimOptions& options) {
  const RobotModel robot = LoadRobot(options.robot);
  const WorldModel world = LoadWorld(options.world);
  const Scenario scenario = FirstExercise(options);
  lockstep::ReplayConfig config;
  config.rig.bridge.dbc_file = options.dbc;
  config.rig.bridge.map_file = options.map;
  config.rig.sim = options.node;
  config.rig.sim.simulator.exercise = LoadRules(options.rules);
  config.rig.sim.simulator.catalogue = Exercises(options, world);
  config.can_log = options.can_log;
  config.out = options.out;
  config.report = options.report;
  lockstep::ReplayLog(config, robot, world, scenario);
}

}  // namespace eod::sim
