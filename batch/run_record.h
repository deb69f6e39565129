#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "batch/expectation.h"

namespace eod::batch {

/// Fingerprints of all that a run depends on.
struct RunInputs {
  std::string scenario, script;
  std::string world, robot, rules, box, program;  ///< the same for a whole batch
  bool operator==(const RunInputs&) const = default;
};

/// What became of a run. Holds nothing of the machine or the time of day.
struct RunRecord {
  std::string scenario;
  std::string script;
  uint64_t repetition = 0;
  RunInputs inputs;
  Outcome expected;
  Outcome outcome;
  double score = 0;        ///< 0..100
  double elapsed_s = 0;    ///< of the exercise, simulated
  double simulated_s = 0;  ///< of the whole run
  int collisions = 0;
  int steps_done = 0;
  int steps = 0;
  std::string why;  ///< kScript: "FILE:LINE: …"; else empty

  bool passes() const { return outcome == expected; }
  bool operator==(const RunRecord&) const = default;
};

nlohmann::ordered_json ToJsonValue(const RunInputs& inputs);
/// Throws nlohmann::json::exception for what is none.
RunInputs InputsOf(const nlohmann::ordered_json& json);

std::string ToJson(const RunRecord& record);

/// Throws std::runtime_error "FILE: …" for what is no record.
RunRecord ReadRecord(const std::filesystem::path& file);

/// By scenario, script and repetition.
void SortRecords(std::vector<RunRecord>& records);

}  // namespace eod::batch
