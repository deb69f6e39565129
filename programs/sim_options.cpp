#include "programs/sim_options.h"

#include <cmath>
#include <cstdio>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "lcmtypes/channels.h"

namespace eod::sim {
namespace {

/// "640x480" into its two numbers; empty text if that went well, as CLI11 wants it.
std::string ParseSize(const std::string& text, CameraConfig& camera) {
  int width = 0;
  int height = 0;
  int used = 0;
  const bool parsed = std::sscanf(text.c_str(), "%4dx%4d%n", &width, &height, &used) == 2 &&
                      used == static_cast<int>(text.size());
  if (!parsed || width < 64 || width > 1920 || height < 48 || height > 1080) {
    return fmt::format("'{}': WIDTHxHEIGHT, allowed 64x48 .. 1920x1080 pixels", text);
  }
  camera.width = width;
  camera.height = height;
  return {};
}

void AddStepOptions(CLI::App& app, SimOptions& options) {
  Duration& period = options.node.simulator.period;
  auto* in_milliseconds =
      app.add_option_function<double>(
             "--period-ms", [&period](double ms) { period = Duration(std::llround(ms * 1e6)); },
             "length of a step [ms], 4 by default")
          ->check(CLI::Range(1.0, 20.0));
  app.add_option_function<double>(
         "--rate", [&period](double hz) { period = Duration(std::llround(1e9 / hz)); },
         "the same as steps a second [Hz], 250 by default")
      ->check(CLI::Range(50.0, 1000.0))
      ->excludes(in_milliseconds);
  app.add_flag("--start", options.node.simulator.start_mission,
               "the mission runs from the first step, without the menu");
}

void AddIsectorOptions(CLI::App& app, SimOptions& options) {
  static const std::map<std::string, Coverage> kCoverage{{"paper", Coverage::kPaper},
                                                         {"extended", Coverage::kExtended}};
  app.add_option("--coverage", options.node.simulator.coverage,
                 "isectors: those of the source paper, or also guards for what it left open")
      ->transform(CLI::CheckedTransformer(kCoverage))
      ->option_text("paper|extended");
  static const std::map<std::string, GraspMode> kGrasp{{"paper", GraspMode::kPaper},
                                                       {"guarded", GraspMode::kGuarded}};
  app.add_option("--grasp", options.node.simulator.grasp,
                 "what takes a charge: the source paper's five lines, or also guards against a bad "
                 "grip")
      ->transform(CLI::CheckedTransformer(kGrasp))
      ->option_text("paper|guarded");
  IsectorRules& rules = options.node.simulator.rules;
  app.add_flag_callback(
      "--no-module-masks", [&rules] { rules.module_masks = false; },
      "isectors are offered the objects of all modules, not of their own alone");
  app.add_flag_callback(
      "--no-dynamic-loading", [&rules] { rules.dynamic_loading = false; },
      "all isectors are cast in every step, whatever is commanded");
  app.add_flag_callback(
      "--fixed-distance", [&rules] { rules.distance_factor = false; },
      "contact always at the distance D0, however fast (without Eq. 2)");
  app.add_flag("--publish-isectors", options.node.publish_isectors,
               "put every step's isector hits on LCM");
}

void AddCameraOptions(CLI::App& app, SimOptions& options) {
  app.add_flag_callback(
      "--no-cameras", [&options] { options.cameras = false; }, "render nothing");
  app.add_option_function<std::string>(
         "--camera-size", [&options](const std::string& text) { ParseSize(text, options.camera); },
         "of the pictures [px], 640x480 by default")
      ->type_name("WxH")
      ->check(CLI::Validator(
          [](const std::string& text) {
            CameraConfig ignored;
            return ParseSize(text, ignored);
          },
          ""));
  app.add_option("--camera-fps", options.camera.rate_hz, "pictures a second of each camera")
      ->check(CLI::Range(1.0, 60.0))
      ->capture_default_str();
  app.add_flag("--isectors", options.camera.draw_isectors,
               "draw isectors and hits into the pictures");
}

void AddLockStepOptions(CLI::App& app, SimOptions& options) {
  const char* group = "Lock-step: replay a CAN log without any other program, same log same bytes";
  auto* lockstep =
      app.add_flag("--lockstep", options.lockstep, "virtual time, as fast as the processor allows");
  auto* log = app.add_option("--can-log", options.can_log, "in: as candump -L writes it");
  auto* out =
      app.add_option("--out", options.out,
                     "out: folder for states.csv, can.log (what the robot sent), result.json");
  auto* dbc = app.add_option("--dbc", options.dbc, "CAN data base of the box");
  auto* map = app.add_option("--map", options.map, "what its signals mean to the robot");
  lockstep->needs(log)->needs(out)->group(group);
  for (auto* option : {log, out, dbc, map}) option->needs(lockstep)->group(group);
}

}  // namespace

void AddSimOptions(CLI::App& app, SimOptions& options) {
  app.add_option("--world", options.world, "SDFormat file")->capture_default_str();
  app.add_option("--robot", options.robot, "SDFormat file")->capture_default_str();
  app.add_option("--scenario", options.scenario, "TOML file, or name of one of --scenarios")
      ->capture_default_str();
  app.add_option("--scenarios", options.scenarios, "folder of what the box's menu can choose")
      ->capture_default_str();
  app.add_option("--repetition", options.repetition,
                 "variation of the scenario: start, places and light within its ranges; 0: as its "
                 "file says");
  app.add_flag("--list", options.list, "print all scenarios of the folder and exit");
  app.add_option("--rules", options.rules, "tuning of the exercise, TOML file")
      ->capture_default_str();
  app.add_option("--report", options.report,
                 "folder for score.json and report.html of a mission, written when it ends");
  AddStepOptions(app, options);
  AddIsectorOptions(app, options);
  AddCameraOptions(app, options);
  AddLockStepOptions(app, options);
}

namespace {

std::string DescribeIsectors(const SimulatorConfig& config) {
  const auto is = [](bool on) { return on ? "on" : "off"; };
  return fmt::format(
      "isectors         {}; module masks {}, dynamic loading {}, {}\n"
      "grasp            {}\n",
      config.coverage == Coverage::kPaper ? "paper" : "extended", is(config.rules.module_masks),
      is(config.rules.dynamic_loading),
      config.rules.distance_factor ? "distance by Eq. 2" : "fixed distance D0",
      config.grasp == GraspMode::kPaper ? "paper" : "guarded");
}

}  // namespace

std::string Describe(const SimOptions& options) {
  const double period_s = ToSeconds(options.node.simulator.period);
  std::string text = fmt::format(
      "eod-sim: the robot in its world\n"
      "world            {}\n"
      "robot            {}\n"
      "scenario         {}, repetition {}; others from {}\n"
      "rules            {}\n"
      "step             {:g} ms ({:g} Hz), zero motion {:g} ms after the last command\n"
      "{}",
      options.world.string(), options.robot.string(), options.scenario, options.repetition,
      options.scenarios.string(), options.rules.string(), 1000 * period_s, 1 / period_s,
      1000 * ToSeconds(options.node.simulator.command_timeout),
      DescribeIsectors(options.node.simulator));
  if (options.lockstep) {
    return text + fmt::format("lock-step        {} into {}, by {} and {}\n",
                              options.can_log.string(), options.out.string(), options.dbc.string(),
                              options.map.string());
  }
  text += options.cameras
              ? fmt::format("cameras          {} at {}x{}, {:g} Hz\n",
                            fmt::join(options.camera.cameras, ", "), options.camera.width,
                            options.camera.height, options.camera.rate_hz)
              : "cameras          none\n";
  for (const char* verb : {"publishes", "hears"}) {
    text += fmt::format("{}\n", verb);
    for (const Channel& channel : kChannels) {
      const std::string_view who = *verb == 'p' ? channel.publisher : channel.subscribers;
      if (who.substr(0, 3) != "sim") continue;
      text += fmt::format("  {:<24} {:<18} {}\n", ChannelName(options.node.channel_prefix, channel),
                          channel.type, channel.rate);
    }
  }
  return text;
}

}  // namespace eod::sim
