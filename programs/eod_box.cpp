#include <cstdio>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "firmware_emu/box_console.h"
#include "firmware_emu/box_report.h"
#include "platform/clock.h"
#include "platform/lcm_station.h"
#include "platform/priority.h"
#include "platform/run_main.h"
#include "platform/run_node.h"
#include "platform/station_options.h"

int main(int argc, char** argv) {
  using namespace eod;
  CLI::App app("eod-box: an emulated control box on a CAN bus");
  StationOptions station;
  box::BoxNodeConfig config;
  config.dbc_file = EOD_DATA_DIR "/dbc/control_box.dbc";
  config.map_file = EOD_DATA_DIR "/dbc/control_box.map.toml";
  box::BoxConsole::Options console_options;
  std::string script_file;
  AddBusOptions(app, station);
  AddStationOptions(app, station);
  app.add_option("--dbc", config.dbc_file, "CAN data base")->capture_default_str();
  app.add_option("--map", config.map_file, "meaning of its signals")->capture_default_str();
  app.add_option("--script", script_file, "operator script (*.boxscript) to play");
  app.add_flag("--keyboard", console_options.keyboard, "drive from this terminal");
  app.add_flag("--stay", console_options.stay, "go on after the script has ended");
  return RunMain(app, EOD_VERSION, argc, argv, [&] {
    config.channel_prefix = station.lcm.channel_prefix;
    if (!script_file.empty()) config.script = box::LoadScript(script_file);
    if (station.describe) {
      fmt::print("{}", box::Describe(config, station.bus_url));
      return;
    }
    RunBeforeOthers();
    const SteadyClock clock;
    if (!console_options.keyboard) config.tell = box::PrintTo(stdout, clock.Now());
    const auto bus = OpenCanBus(station, clock);
    const auto lcm = OpenLcm(station.lcm);
    box::BoxNode node(config, *bus, *lcm, clock);
    box::BoxConsole console(node, console_options);
    if (config.tell) config.tell(clock.Now(), "ready on " + bus->url());
    RunNode(console, bus.get(), *lcm, clock);
    if (const auto failure = node.script_failure()) throw std::runtime_error(*failure);
  });
}
