#include <iostream>

#include <CLI/CLI.hpp>

#include "platform/recording_can_bus.h"
#include "platform/run_main.h"
#include "platform/run_node.h"
#include "platform/station_options.h"
#include "programs/recorder_options.h"
#include "recorder/recorder_node.h"

using eod::recorder::RecorderConfig;

namespace {

void Record(const RecorderConfig& config, const eod::StationOptions& station) {
  const eod::recorder::RunFolder folder(config.out);
  const eod::SteadyClock clock;
  const auto lcm = eod::OpenLcm(station.lcm);
  auto open_bus = eod::OpenCanBus(station, clock);
  folder.RemoveEarlierRun();
  eod::RecordingCanBus bus(std::move(open_bus), {folder.can_log(), "vcan0"}, clock);
  eod::recorder::RecorderNode node(config, folder, bus, *lcm, clock);
  eod::SayReady(bus.url());
  eod::RunNode(node, &bus, *lcm, clock);
  node.Finish();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Records a run: bus, messages, pictures, delays. Listens only."};
  eod::StationOptions station;
  RecorderConfig config;
  config.out = "out/recording";
  config.dbc_file = EOD_DATA_DIR "/dbc/control_box.dbc";
  config.map_file = EOD_DATA_DIR "/dbc/control_box.map.toml";
  eod::AddBusOptions(app, station);
  eod::AddStationOptions(app, station);
  AddRecorderOptions(app, config);
  return eod::RunMain(app, EOD_VERSION, argc, argv, [&] {
    config.channel_prefix = station.lcm.channel_prefix;
    if (station.describe) {
      std::cout << eod::recorder::Describe(config, station.bus_url);
    } else {
      Record(config, station);
    }
  });
}
