#include <iostream>

#include <CLI/CLI.hpp>

#include "canbridge/bridge_node.h"
#include "canbridge/describe.h"
#include "platform/priority.h"
#include "platform/run_main.h"
#include "platform/run_node.h"
#include "platform/station_options.h"

namespace {

void Bridge(const eod::bridge::BridgeNodeConfig& config, const eod::StationOptions& station) {
  eod::RunBeforeOthers();
  const eod::SteadyClock clock;
  const auto lcm = eod::OpenLcm(station.lcm);
  const auto bus = eod::OpenCanBus(station, clock);
  eod::bridge::BridgeNode node(config, *bus, *lcm, clock);
  eod::SayReady(bus->url());
  eod::RunNode(node, bus.get(), *lcm, clock);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Couples a control box on CAN with the simulator on LCM: box frames become commands, robot "
      "state and alarms become frames. Supervises the link; on any doubt nothing moves."};
  eod::StationOptions station;
  eod::bridge::BridgeNodeConfig config{.dbc_file = EOD_DATA_DIR "/dbc/control_box.dbc",
                                       .map_file = EOD_DATA_DIR "/dbc/control_box.map.toml",
                                       .channel_prefix = {},
                                       .bridge = {}};
  eod::AddBusOptions(app, station);
  eod::AddStationOptions(app, station);
  app.add_option("--dbc", config.dbc_file, "CAN data base of the box")
      ->type_name("FILE")
      ->capture_default_str();
  app.add_option("--map", config.map_file, "what its signals mean to the robot")
      ->type_name("FILE")
      ->capture_default_str();
  return eod::RunMain(app, EOD_VERSION, argc, argv, [&] {
    config.channel_prefix = station.lcm.channel_prefix;
    if (station.describe) {
      std::cout << eod::bridge::DescribeBridge(config, station.bus_url);
    } else {
      Bridge(config, station);
    }
  });
}
