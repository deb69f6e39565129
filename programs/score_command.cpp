#include "programs/score_command.h"

#include <stdexcept>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <lcm/lcm-cpp.hpp>

#include "eod/mission_status_t.hpp"
#include "eod/robot_state_t.hpp"

#include "lcmtypes/channels.h"
#include "sim/message_node.h"
#include "sim/score/report.h"
#include "sim/score/scorer.h"

namespace eod::sim {
namespace {

[[noreturn]] void Fail(const ScoreOptions& options, const std::string& what) {
  throw std::runtime_error(fmt::format("{}: {}", options.log.string(), what));
}

/// Reads an event into a message, which keeps its memory from one to the next.
template <typename Message>
void Decode(const lcm::LogEvent& event, const ScoreOptions& options, Message& message) {
  if (message.decode(event.data, 0, static_cast<unsigned>(event.datalen)) < 0) {
    Fail(options, fmt::format("message {} on {} is damaged, or of another version", event.eventnum,
                              event.channel));
  }
}

}  // namespace

CLI::App& AddScoreCommand(CLI::App& app, ScoreOptions& options) {
  CLI::App& score =
      *app.add_subcommand("score", "scores a recorded mission from its LCM log alone");
  score.add_option("LOG", options.log, "as eod-recorder and lcm-logger write it")->required();
  score.add_option("--scenario", options.scenario, "that was driven, TOML file")->required();
  score.add_option("--out", options.out, "folder for score.json and report.html")->required();
  score.add_option("--world", options.world, "that it was driven in, SDFormat file")
      ->capture_default_str();
  score.add_option("--rules", options.rules, "of the exercise, TOML file")->capture_default_str();
  score.add_option("--channel-prefix", options.channel_prefix, "of the station in the log");
  return score;
}

ScoreSheet ScoreLog(const ScoreOptions& options) {
  const Scenario scenario = LoadScenario(options.scenario);
  const WorldModel world = LoadWorld(options.world);
  Scorer scorer(scenario, world.Module(scenario.module), LoadRules(options.rules));
  if (!std::filesystem::is_regular_file(options.log)) Fail(options, "no such log");
  lcm::LogFile log(options.log.string(), "r");
  if (!log.good()) Fail(options, "cannot be read");
  const std::string states = ChannelName(options.channel_prefix, kRobotStateChannel);
  const std::string missions = ChannelName(options.channel_prefix, kMissionStatusChannel);
  robot_state_t state;
  mission_status_t mission;
  while (const lcm::LogEvent* event = log.readNextEvent()) {
    if (event->channel == states) {
      Decode(*event, options, state);
      scorer.Advance(ToSample(state));
    } else if (event->channel == missions) {
      Decode(*event, options, mission);
      if (mission.scenario != scenario.name) {
        Fail(options, fmt::format("scenario '{}' was driven, not '{}' of {}", mission.scenario,
                                  scenario.name, scenario.file.string()));
      }
    }
  }
  if (!scorer.has_started()) Fail(options, "no mission in it");
  return scorer.Sheet();
}

void RunScoreCommand(const ScoreOptions& options) {
  const ScoreSheet sheet = ScoreLog(options);
  WriteReport(sheet, options.out);
  fmt::print("{}: {}, {:.1f} of 100 points, {}\n", sheet.scenario, sheet.result, sheet.total,
             sheet.passed ? "passed" : "not passed");
  if (sheet.lost_s > 0) {
    fmt::print(
        "{}: {:.3f} s of the mission are not in it: this is not the score of the whole run\n",
        options.log.string(), sheet.lost_s);
  }
}

}  // namespace eod::sim
