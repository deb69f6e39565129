#pragma once

#include <span>
#include <string>
#include <vector>

#include "batch/run_record.h"

namespace eod::batch {

/// What the runs of a scenario say about it, or those of all.
struct ScenarioSummary {
  std::string scenario;
  int runs = 0;               ///< that were to succeed
  int successes = 0;          ///< of them
  double rate = 0;            ///< successes a run; 0 without runs
  double lower_bound = 0;     ///< of the rate, at kConfidence
  bool allows_claim = false;  ///< kClaim at kConfidence
  double mean_score = 0;      ///< of these runs
  double mean_elapsed_s = 0;
  int collisions = 0;  ///< in all of them
  int drills = 0;      ///< runs that were to end otherwise
  int drills_as_expected = 0;
};

struct Summary {
  std::vector<ScenarioSummary> scenarios;  ///< sorted by name
  ScenarioSummary total;
  int unexpected = 0;  ///< runs that did not end as they were to
};

Summary Summarise(std::span<const RunRecord> sorted);

// Text of the files; the same records give the same bytes.
std::string ToCsv(std::span<const RunRecord> sorted);
std::string ToJson(const Summary& summary);
/// For people.
std::string ToTable(const Summary& summary);

}  // namespace eod::batch
