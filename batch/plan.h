#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "batch/expectation.h"
#include "firmware_emu/script.h"
#include "sim/scenario/scenario.h"

namespace eod::batch {

/// A scenario and one of its scripts, to be repeated.
struct Pair {
  sim::Scenario scenario;
  std::string script_name;  ///< of its file without ".boxscript"
  box::Script script;       ///< its `file` is the name alone: the same on every machine
  Outcome expected;
  std::string scenario_print, script_print;  ///< fingerprints of the files
};

/// "bomb_ground_m.dropped.0003"; names sort as runs do.
std::string RunName(const std::string& script, uint64_t repetition);

/// One run: a pair and which repetition.
struct PlannedRun {
  const Pair* pair = nullptr;
  uint64_t repetition = 0;
  std::string name() const { return RunName(pair->script_name, repetition); }
};

struct Plan {
  std::vector<Pair> pairs;           ///< sorted by scenario, then script
  std::vector<std::string> notices;  ///< scripts without a scenario, scenarios without a script
};

/// Which part of a plan is done here: run k of it belongs to shard k mod count.
struct Shard {
  int index = 0;
  int count = 1;
};
/// "1/3". Throws std::runtime_error with what is allowed.
Shard ParseShard(const std::string& text);

/// Finds the scripts NAME.boxscript and NAME.WHAT.boxscript of each scenario NAME. `only` leaves
/// out scenarios that it does not name, unless it is empty. Throws what the readers of both files
/// throw, for a name in `only` that no scenario has, and if there is nothing to run.
Plan MakePlan(const std::filesystem::path& scenarios, const std::filesystem::path& scripts,
              std::span<const std::string> only);

/// All runs of the plan in its order, or those of one shard. `plan` must outlive them.
std::vector<PlannedRun> RunsOf(const Plan& plan, uint64_t repetitions, const Shard& shard = {});

}  // namespace eod::batch
