#include <iostream>

#include <CLI/CLI.hpp>

#include "console/console_node.h"
#include "platform/run_main.h"
#include "platform/run_node.h"
#include "platform/station_options.h"

int main(int argc, char** argv) {
  CLI::App app{"Shows the robot's camera pictures in a browser."};
  eod::StationOptions station;
  eod::console::ConsoleConfig config;
  eod::AddStationOptions(app, station);
  app.add_option("--address", config.address, "IPv4 that browsers come to; 0.0.0.0 for all")
      ->capture_default_str();
  app.add_option("--port", config.port, "TCP port; 0 for any free one")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  return eod::RunMain(app, EOD_VERSION, argc, argv, [&] {
    config.channel_prefix = station.lcm.channel_prefix;
    if (station.describe) {
      std::cout << eod::console::Describe(config);
      return;
    }
    const eod::SteadyClock clock;
    const auto lcm = eod::OpenLcm(station.lcm);
    eod::console::ConsoleNode node(config, *lcm);
    eod::SayReady(node.url());
    eod::RunNode(node, nullptr, *lcm, clock);
  });
}
