#include "sim/scenario/scenario.h"

#include <array>
#include <string_view>

#include <fmt/format.h>

#include "sim/rules/toml_table.h"

namespace eod::sim {
namespace {

constexpr std::array<std::string_view, 18> kScenarioKeys = {
    "name",  "title",    "module", "difficulty", "par_time_s", "time_limit_s",
    "seed",  "critical", "step",   "start",      "weather",    "link",
    "score", "place",    "fault",  "area",       "precision",  "procedure"};
constexpr std::array<std::string_view, 4> kWeatherKeys = {"light", "lights", "visibility_m",
                                                          "rain_mm_per_h"};
constexpr std::array<std::string_view, 3> kLights = {"day", "dusk", "night"};  // as the enum

constexpr size_t kMaxSteps = 15;     // ROB_MISSION.Steps has four bits
constexpr double kMaxTime = 86400;   // [s]
constexpr double kMaxLength = 3000;  // [m] the whole world

/// What may end an exercise beside its time limit, and at the instructor's word.
struct CriticalName {
  std::string_view name;
  FailReason reason;
};
constexpr std::array kCritical = {CriticalName{"detonation", FailReason::kExploded},
                                  CriticalName{"rollover", FailReason::kRollover},
                                  CriticalName{"out_of_area", FailReason::kOutOfArea},
                                  CriticalName{"link_lost", FailReason::kLinkLost},
                                  CriticalName{"estop", FailReason::kEstop},
                                  CriticalName{"bomb_lost", FailReason::kBombLost},
                                  CriticalName{"wrong_order", FailReason::kWrongOrder}};

FailReasons ReadCritical(const TomlTable& table) {
  std::array<std::string_view, kCritical.size()> names;
  FailReasons critical = kEveryReason;
  for (size_t i = 0; i < kCritical.size(); ++i) {
    names[i] = kCritical[i].name;
    critical &= ~SetOf(kCritical[i].reason);
  }
  for (const size_t choice : table.Choices("critical", names)) {
    critical |= SetOf(kCritical[choice].reason);
  }
  return critical;
}

void ReadWeather(const TomlTable& table, Scenario& scenario) {
  table.RejectUnknownKeys(kWeatherKeys);
  if (table.Has("light") && table.Has("lights")) {
    table.Fail(table.LineOf("lights"), "either light or lights");
  }
  for (const size_t light : table.Choices("lights", kLights)) {
    scenario.lights.push_back(static_cast<Weather::Light>(light));
  }
  const size_t first = scenario.lights.empty() ? 0 : static_cast<size_t>(scenario.lights.front());
  scenario.weather = {.light = static_cast<Weather::Light>(table.Choice("light", kLights, first)),
                      .visibility = table.Number("visibility_m", 5, 10000, 0.0),
                      .rain = table.Number("rain_mm_per_h", 0, 50, 0.0)};
}

std::vector<Eigen::Vector2d> ReadArea(const TomlTable& table) {
  constexpr std::array<std::string_view, 1> kAreaKeys = {"corners_m"};
  table.RejectUnknownKeys(kAreaKeys);
  return table.Points("corners_m", 3, -kMaxLength, kMaxLength);
}

}  // namespace

Scenario LoadScenario(const std::filesystem::path& file) {
  const toml::table root = ParseToml(file, "scenario");
  const TomlTable table(file, root);
  table.RejectUnknownKeys(kScenarioKeys);
  Scenario scenario;
  scenario.file = file;
  scenario.name = table.Text("name");
  scenario.title = table.Text("title", "");
  scenario.module = static_cast<int>(table.Integer("module", 1, 5));
  scenario.difficulty = static_cast<int>(table.Integer("difficulty", 1, 5, 1));
  scenario.par_time_s = table.Number("par_time_s", 0, kMaxTime, 0.0);
  scenario.time_limit_s = table.Number("time_limit_s", 0, kMaxTime, 0.0);
  scenario.seed = table.Integer("seed", INT64_MIN, INT64_MAX, 0);
  if (table.Has("critical")) scenario.critical = ReadCritical(table);
  if (table.Has("area")) scenario.area = ReadArea(table.Table("area"));
  if (table.Has("start")) scenario.start = ReadPlacement(table.Table("start"), false);
  if (table.Has("weather")) ReadWeather(table.Table("weather"), scenario);
  if (table.Has("link")) scenario.link = ReadControlLinkSpec(table.Table("link"));
  if (table.Has("score")) scenario.rubric = ReadRubric(table.Table("score"));
  for (const TomlTable& measure : table.Tables("precision")) {
    scenario.precision.push_back(ReadPrecisionSpec(measure));
  }
  for (const TomlTable& item : table.Tables("procedure")) {
    scenario.procedure.push_back(ReadProcedureSpec(item));
  }
  for (const TomlTable& place : table.Tables("place")) {
    scenario.places.push_back(ReadPlacement(place, true));
  }
  for (const TomlTable& step : table.Tables("step")) {
    if (scenario.steps.size() == kMaxSteps) {
      table.Fail(step.line(),
                 fmt::format("more than {} steps, which the box cannot show", kMaxSteps));
    }
    scenario.steps.push_back(ReadTaskStep(step));
  }
  for (const TomlTable& fault : table.Tables("fault")) {
    scenario.faults.push_back(ReadFaultSpec(fault));
    const int steps = static_cast<int>(scenario.steps.size());
    if (scenario.faults.back().after_step > steps) {
      fault.Fail(fault.LineOf("after_step"),
                 fmt::format("after_step = {}, allowed 1 .. {}, the number of steps",
                             scenario.faults.back().after_step, steps));
    }
  }
  return scenario;
}

}  // namespace eod::sim
