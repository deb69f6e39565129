#pragma once

#include <filesystem>
#include <string>

#include <CLI/App.hpp>

#include "sim/score/score_sheet.h"

namespace eod::sim {

/// What the command line of `eod-sim score` decides.
struct ScoreOptions {
  std::filesystem::path log;
  std::filesystem::path scenario;
  std::filesystem::path world = EOD_DATA_DIR "/sim/worlds/training_ground.sdf";
  std::filesystem::path rules = EOD_DATA_DIR "/sim/rules/eod_rules.toml";
  std::filesystem::path out;
  std::string channel_prefix;
};

/// Adds the subcommand. Values go to `options`, which must outlive the parsing.
CLI::App& AddScoreCommand(CLI::App& app, ScoreOptions& options);

/// Scores the last mission in an LCM log, from the log's messages alone. Throws std::runtime_error
/// with one line for files that cannot be read, messages of another version, a log of another
/// scenario and one without a mission.
ScoreSheet ScoreLog(const ScoreOptions& options);

/// The same, written into `options.out` and told in a line.
void RunScoreCommand(const ScoreOptions& options);

}  // namespace eod::sim
