#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <sys/resource.h>

#include "platform/run_main.h"
#include "platform/run_node.h"
#include "programs/sim_options.h"
#include "sim/picture_node.h"

namespace {

void Simulate(const eod::sim::SimOptions& options, const eod::StationOptions& station) {
  using namespace eod::sim;
  // Steps and messages before strangers, where the system lets us; the cameras' thread steps back.
  setpriority(PRIO_PROCESS, 0, -15);
  const RobotModel robot = LoadRobot(options.robot);
  const WorldModel world = LoadWorld(options.world);
  const Scenario scenario = LoadScenario(options.scenario);
  const eod::SteadyClock clock;
  const auto lcm = eod::OpenLcm(station.lcm);
  SimNode node(options.node, robot, world, scenario, *lcm, clock);

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
  eod::SayReady(station.lcm.url.empty() ? "LCM" : station.lcm.url);
  const uint64_t overruns = eod::RunNode(node, nullptr, *lcm, clock);
  fmt::print("{} steps, {} overruns, {} pictures\n", node.simulator().last().step, overruns,
             cameras ? cameras->pictures() : 0);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Simulates the robot in its world, and shows it to its cameras."};
  eod::StationOptions station;
  eod::sim::SimOptions options;
  eod::AddStationOptions(app, station);
  eod::sim::AddSimOptions(app, options);
  return eod::RunMain(app, EOD_VERSION, argc, argv, [&] {
    options.node.channel_prefix = station.lcm.channel_prefix;
    if (station.describe) {
      std::cout << eod::sim::Describe(options);
    } else {
      Simulate(options, station);
    }
  });
}
