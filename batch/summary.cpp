#include "batch/summary.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "batch/confidence.h"

namespace eod::batch {
namespace {

using Json = nlohmann::ordered_json;

void Take(const RunRecord& record, ScenarioSummary& summary) {
  if (record.expected != Outcome{}) {
    ++summary.drills;
    if (record.passes()) ++summary.drills_as_expected;
    return;
  }
  ++summary.runs;
  if (record.passes()) ++summary.successes;
  summary.mean_score += record.score;  // sums until Finish
  summary.mean_elapsed_s += record.elapsed_s;
  summary.collisions += record.collisions;
}

void Finish(ScenarioSummary& summary) {
  if (summary.runs == 0) return;
  summary.rate = static_cast<double>(summary.successes) / summary.runs;
  summary.lower_bound = LowerBound(summary.successes, summary.runs, kConfidence);
  summary.allows_claim = AllowsClaim(summary.successes, summary.runs);
  summary.mean_score /= summary.runs;
  summary.mean_elapsed_s /= summary.runs;
}

/// A field of a CSV file, as RFC 4180 has it.
std::string Field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + '"';
}

Json JsonOf(const ScenarioSummary& summary) {
  return {{"scenario", summary.scenario},
          {"runs", summary.runs},
          {"successes", summary.successes},
          {"rate", summary.rate},
          {"lower_bound", summary.lower_bound},
          {"allows_claim", summary.allows_claim},
          {"mean_score", summary.mean_score},
          {"mean_elapsed_s", summary.mean_elapsed_s},
          {"collisions", summary.collisions},
          {"drills", summary.drills},
          {"drills_as_expected", summary.drills_as_expected}};
}

std::string Line(const ScenarioSummary& summary) {
  const std::string runs =
      summary.runs == 0
          ? fmt::format("{:>11} {:>6} {:>8} {:>5} {:>6} {:>8} {:>10}", "-", "", "", "", "", "", "")
          : fmt::format("{:>5} of {:<3}{:>5.0f} % {:>6.1f} % {:>5} {:>6.1f} {:>6.0f} s {:>10}",
                        summary.successes, summary.runs, 100 * summary.rate,
                        100 * summary.lower_bound, summary.allows_claim ? "yes" : "no",
                        summary.mean_score, summary.mean_elapsed_s, summary.collisions);
  const std::string drills =
      summary.drills == 0 ? "-"
                          : fmt::format("{} of {}", summary.drills_as_expected, summary.drills);
  return fmt::format("{:<24}{} {:>10}\n", summary.scenario, runs, drills);
}

}  // namespace

Summary Summarise(std::span<const RunRecord> sorted) {
  Summary summary;
  summary.total.scenario = "total";
  for (const RunRecord& record : sorted) {
    if (summary.scenarios.empty() || summary.scenarios.back().scenario != record.scenario) {
      summary.scenarios.push_back({.scenario = record.scenario});
    }
    Take(record, summary.scenarios.back());
    Take(record, summary.total);
    if (!record.passes()) ++summary.unexpected;
  }
  for (ScenarioSummary& scenario : summary.scenarios) Finish(scenario);
  Finish(summary.total);
  return summary;
}

std::string ToCsv(std::span<const RunRecord> sorted) {
  std::string text =
      "scenario,script,repetition,expected,outcome,pass,score,elapsed_s,collisions,fail_reason,"
      "steps_done,steps,why\n";
  for (const RunRecord& record : sorted) {
    const std::string outcome = TextOf(record.outcome);
    const size_t blank = outcome.find(' ');
    text += fmt::format("{},{},{},{},{},{},{:.2f},{:.3f},{},{},{},{},{}\n", Field(record.scenario),
                        Field(record.script), record.repetition, TextOf(record.expected),
                        outcome.substr(0, blank), record.passes() ? 1 : 0, record.score,
                        record.elapsed_s, record.collisions,
                        blank == std::string::npos ? "none" : outcome.substr(blank + 1),
                        record.steps_done, record.steps, Field(record.why));
  }
  return text;
}

std::string ToJson(const Summary& summary) {
  Json scenarios = Json::array();
  for (const ScenarioSummary& scenario : summary.scenarios) scenarios.push_back(JsonOf(scenario));
  const Json json = {{"confidence", kConfidence},
                     {"claim", kClaim},
                     {"unexpected", summary.unexpected},
                     {"total", JsonOf(summary.total)},
                     {"scenarios", scenarios}};
  return json.dump(2) + "\n";
}

std::string ToTable(const Summary& summary) {
  std::string text = fmt::format("{:<24}{:>11} {:>6} {:>8} {:>5} {:>6} {:>8} {:>10} {:>10}\n",
                                 "scenario", "succeeded", "rate", "at least", "80/80", "score",
                                 "time", "collisions", "drills");
  for (const ScenarioSummary& scenario : summary.scenarios) text += Line(scenario);
  text += Line(summary.total);
  return text + fmt::format(
                    "at least: one-sided lower bound of the rate at {:.0f} % confidence (Clopper-"
                    "Pearson); 80/80: it is {:.0f} % or more\n",
                    100 * kConfidence, 100 * kClaim);
}

}  // namespace eod::batch
