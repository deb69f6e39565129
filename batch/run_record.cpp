#include "batch/run_record.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "batch/text_file.h"

namespace eod::batch {

using Json = nlohmann::ordered_json;

Json ToJsonValue(const RunInputs& inputs) {
  return {{"scenario", inputs.scenario}, {"script", inputs.script}, {"world", inputs.world},
          {"robot", inputs.robot},       {"rules", inputs.rules},   {"box", inputs.box},
          {"program", inputs.program}};
}

RunInputs InputsOf(const Json& json) {
  return {.scenario = json.at("scenario"),
          .script = json.at("script"),
          .world = json.at("world"),
          .robot = json.at("robot"),
          .rules = json.at("rules"),
          .box = json.at("box"),
          .program = json.at("program")};
}

std::string ToJson(const RunRecord& record) {
  const Json json = {{"scenario", record.scenario},
                     {"script", record.script},
                     {"repetition", record.repetition},
                     {"expected", TextOf(record.expected)},
                     {"outcome", TextOf(record.outcome)},
                     {"score", record.score},
                     {"elapsed_s", record.elapsed_s},
                     {"simulated_s", record.simulated_s},
                     {"collisions", record.collisions},
                     {"steps_done", record.steps_done},
                     {"steps", record.steps},
                     {"why", record.why},
                     {"inputs", ToJsonValue(record.inputs)}};
  return json.dump(2) + "\n";
}

RunRecord ReadRecord(const std::filesystem::path& file) {
  try {
    const Json json = Json::parse(ReadText(file));
    return {.scenario = json.at("scenario"),
            .script = json.at("script"),
            .repetition = json.at("repetition"),
            .inputs = InputsOf(json.at("inputs")),
            .expected = ParseOutcome(json.at("expected").get<std::string>()),
            .outcome = ParseOutcome(json.at("outcome").get<std::string>()),
            .score = json.at("score"),
            .elapsed_s = json.at("elapsed_s"),
            .simulated_s = json.at("simulated_s"),
            .collisions = json.at("collisions"),
            .steps_done = json.at("steps_done"),
            .steps = json.at("steps"),
            .why = json.at("why")};
  } catch (const std::exception& error) {
    throw std::runtime_error(
        fmt::format("{}: no record of a run: {}", file.string(), error.what()));
  }
}

void SortRecords(std::vector<RunRecord>& records) {
  const auto key = [](const RunRecord& record) {
    return std::tie(record.scenario, record.script, record.repetition);
  };
  std::sort(records.begin(), records.end(),
            [key](const RunRecord& a, const RunRecord& b) { return key(a) < key(b); });
}

}  // namespace eod::batch
