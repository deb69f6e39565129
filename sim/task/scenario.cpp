#include "sim/task/scenario.h"

#include <array>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "sim/rules/toml_table.h"

namespace eod::sim {
namespace {

constexpr std::array<std::string_view, 7> kScenarioKeys = {
    "name", "title", "module", "par_time_s", "time_limit_s", "seed", "step"};
constexpr std::array<std::string_view, 10> kStepKeys = {
    "kind", "object", "distance_m", "tolerance_m", "x_m",
    "y_m",  "time_s", "tilt_deg",   "text",        "weight"};

/// What a step of a kind has to say.
enum Need : unsigned {
  kObject = 1,
  kDistance = 2,
  kTolerance = 4,
  kPlace = 8,
  kTime = 16,
};
struct KindName {
  std::string_view name;
  TaskStep::Kind kind;
  unsigned needs;
};
constexpr std::array kKinds = {
    KindName{"contact", TaskStep::Kind::kContact, 0},
    KindName{"clear", TaskStep::Kind::kClear, kDistance},
    KindName{"pass_gate", TaskStep::Kind::kPassGate, kObject | kDistance},
    KindName{"stop_at", TaskStep::Kind::kStopAt, kObject | kDistance | kTolerance},
    KindName{"reach", TaskStep::Kind::kReach, kTolerance | kPlace},
    KindName{"grasp", TaskStep::Kind::kGrasp, kObject},
    KindName{"lift", TaskStep::Kind::kLift, kDistance},
    KindName{"place_in_vessel", TaskStep::Kind::kPlaceInVessel, kObject},
    KindName{"disrupt", TaskStep::Kind::kDisrupt, 0},
    KindName{"climb", TaskStep::Kind::kClimb, kDistance | kTolerance | kPlace},
    KindName{"hold_still", TaskStep::Kind::kHoldStill, kTime},
    KindName{"retreat", TaskStep::Kind::kRetreat, kObject | kDistance}};

constexpr double kMaxLength = 3000;  // [m] the whole world
constexpr double kMaxTime = 86400;   // [s]

const KindName& ReadKind(const TomlTable& reader) {
  const std::string name = reader.Text("kind");
  std::array<std::string_view, kKinds.size()> names;
  for (size_t i = 0; i < kKinds.size(); ++i) {
    if (kKinds[i].name == name) return kKinds[i];
    names[i] = kKinds[i].name;
  }
  reader.Fail(reader.LineOf("kind"), fmt::format("kind = '{}' is unknown; did you mean '{}'?", name,
                                                 NearestName(name, names)));
}

TaskStep ReadStep(const TomlTable& reader) {
  reader.RejectUnknownKeys(kStepKeys);
  TaskStep step;
  const KindName& kind = ReadKind(reader);
  const auto needs = [&kind](Need need) { return (kind.needs & need) != 0; };
  step.kind = kind.kind;
  step.text = reader.Text("text");
  step.weight = reader.Number("weight", 0, 100, 1.0);
  step.object = needs(kObject) ? reader.Text("object") : reader.Text("object", "");
  if (needs(kDistance)) step.distance = reader.Number("distance_m", 0, kMaxLength);
  if (needs(kTolerance)) step.tolerance = reader.Number("tolerance_m", 0, kMaxLength);
  if (needs(kPlace)) {
    step.x = reader.Number("x_m", -kMaxLength, kMaxLength);
    step.y = reader.Number("y_m", -kMaxLength, kMaxLength);
  }
  if (needs(kTime)) {
    step.time = reader.Number("time_s", 0, kMaxTime);
    step.tilt = reader.Number("tilt_deg", 0, 90, 0.0) * std::numbers::pi / 180;
  }
  return step;
}

}  // namespace

Scenario LoadScenario(const std::filesystem::path& file) {
  const toml::table table = ParseToml(file, "scenario");
  const TomlTable reader(file, table);
  reader.RejectUnknownKeys(kScenarioKeys);
  Scenario scenario;
  scenario.file = file;
  scenario.name = reader.Text("name");
  scenario.title = reader.Text("title", "");
  scenario.module = static_cast<int>(reader.Integer("module", 1, 5));
  scenario.par_time_s = reader.Number("par_time_s", 0, kMaxTime, 0.0);
  scenario.time_limit_s = reader.Number("time_limit_s", 0, kMaxTime, 0.0);
  scenario.seed = reader.Integer("seed", INT64_MIN, INT64_MAX, 0);

  const toml::node* steps = table.get("step");
  if (steps == nullptr) return scenario;
  if (!steps->is_array_of_tables()) {
    reader.Fail(reader.LineOf("step"), "'step' has to be a list of tables: [[step]]");
  }
  for (const toml::node& step : *steps->as_array()) {
    scenario.steps.push_back(ReadStep(TomlTable(file, *step.as_table())));
  }
  return scenario;
}

}  // namespace eod::sim
