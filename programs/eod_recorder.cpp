#include <iostream>
#include <map>
#include <string>

#include <CLI/CLI.hpp>

#include "platform/recording_can_bus.h"
#include "platform/run_main.h"
#include "platform/run_node.h"
#include "platform/station_options.h"
#include "recorder/recorder_node.h"

using eod::recorder::RecorderConfig;
using eod::recorder::Until;

namespace {

void AddRecorderOptions(CLI::App& app, RecorderConfig& config) {
  static const std::map<std::string, Until> kEnds{{"mission-end", Until::kMissionEnd},
                                                  {"script-done", Until::kScriptDone}};
  app.add_option("--out", config.out, "folder for the recording")->capture_default_str();
  app.add_option("--dbc", config.dbc_file, "CAN data base of the box")->capture_default_str();
  app.add_option("--map", config.map_file, "what its signals mean")->capture_default_str();
  app.add_option("--bit-rate", config.bit_rate, "of the bus [bit/s], to tell its load")
      ->check(CLI::Range(10'000, 1'000'000))
      ->capture_default_str();
  app.add_option("--picture-period", config.picture_period_s, "between two kept pictures [s]")
      ->check(CLI::Range(0.05, 3600.0))
      ->capture_default_str();
  app.add_option("--until", config.until, "end by itself: mission-end, script-done")
      ->transform(CLI::CheckedTransformer(kEnds));
  app.add_option("--seconds", config.seconds, "end after so long at the latest [s]")
      ->check(CLI::Range(0.1, 1e6));
  app.add_flag("--plain", config.plain, "print lines instead of one live line");
}

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
