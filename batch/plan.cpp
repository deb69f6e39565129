#include "batch/plan.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>

#include "batch/fingerprint.h"
#include "batch/text_file.h"
#include "sim/scenario/catalogue.h"

namespace eod::batch {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kScriptEnding = ".boxscript";

std::vector<fs::path> ScriptsIn(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    throw std::runtime_error(fmt::format("{}: is no folder of scripts", folder.string()));
  }
  std::vector<fs::path> scripts;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == kScriptEnding) scripts.push_back(entry.path());
  }
  std::sort(scripts.begin(), scripts.end());
  return scripts;
}

/// NAME of NAME.WHAT.boxscript.
std::string ScenarioNameOf(const fs::path& script) {
  const std::string stem = script.stem().string();
  return stem.substr(0, stem.find('.'));
}

Pair MakePair(const sim::Scenario& scenario, const fs::path& file) {
  const std::string text = ReadText(file);
  Pair pair;
  pair.scenario = scenario;
  pair.script_name = file.stem().string();
  pair.expected = ExpectedOf(file, text);
  pair.script = box::ParseScript(text, file);
  pair.script.file = file.filename();
  pair.scenario_print = FingerprintOfFile(scenario.file);
  pair.script_print = FingerprintOf(text);
  return pair;
}

void KeepOnly(std::span<const std::string> only, std::vector<sim::Scenario>& scenarios) {
  if (only.empty()) return;
  for (const std::string& name : only) {
    if (sim::FindScenario(scenarios, name) == nullptr) {
      throw std::runtime_error(fmt::format("no scenario is named '{}'", name));
    }
  }
  std::erase_if(scenarios, [only](const sim::Scenario& scenario) {
    return std::find(only.begin(), only.end(), scenario.name) == only.end();
  });
}

}  // namespace

std::string RunName(const std::string& script, uint64_t repetition) {
  return fmt::format("{}.{:04}", script, repetition);
}

Shard ParseShard(const std::string& text) {
  Shard shard;
  int used = 0;
  const bool parsed =
      std::sscanf(text.c_str(), "%6d/%6d%n", &shard.index, &shard.count, &used) == 2 &&
      used == static_cast<int>(text.size());
  if (!parsed || shard.count < 1 || shard.index < 0 || shard.index >= shard.count) {
    throw std::runtime_error(fmt::format("'{}': I/N with I from 0 to N-1, such as 0/3", text));
  }
  return shard;
}

Plan MakePlan(const fs::path& scenarios, const fs::path& scripts,
              std::span<const std::string> only) {
  std::vector<sim::Scenario> catalogue = sim::LoadCatalogue(scenarios);
  const std::vector<sim::Scenario> all = catalogue;
  KeepOnly(only, catalogue);
  Plan plan;
  std::map<std::string, int> scripts_of;
  for (const fs::path& file : ScriptsIn(scripts)) {
    const std::string name = ScenarioNameOf(file);
    if (const sim::Scenario* scenario = sim::FindScenario(catalogue, name)) {
      plan.pairs.push_back(MakePair(*scenario, file));
      ++scripts_of[name];
    } else if (sim::FindScenario(all, name) == nullptr) {
      plan.notices.push_back(
          fmt::format("{}: no scenario is named '{}': left out", file.filename().string(), name));
    }
  }
  for (const sim::Scenario& scenario : catalogue) {
    if (scripts_of.contains(scenario.name)) continue;
    plan.notices.push_back(fmt::format("{}: has no script: left out", scenario.name));
  }
  if (plan.pairs.empty()) {
    throw std::runtime_error(fmt::format("{}: no script NAME.boxscript of a scenario NAME in {}",
                                         scripts.string(), scenarios.string()));
  }
  std::sort(plan.pairs.begin(), plan.pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.scenario.name, a.script_name) < std::tie(b.scenario.name, b.script_name);
  });
  return plan;
}

std::vector<PlannedRun> RunsOf(const Plan& plan, uint64_t repetitions, const Shard& shard) {
  std::vector<PlannedRun> runs;
  uint64_t k = 0;
  for (const Pair& pair : plan.pairs) {
    for (uint64_t repetition = 0; repetition < repetitions; ++repetition, ++k) {
      const bool is_ours =
          k % static_cast<uint64_t>(shard.count) == static_cast<uint64_t>(shard.index);
      if (is_ours) runs.push_back({.pair = &pair, .repetition = repetition});
    }
  }
  return runs;
}

}  // namespace eod::batch
