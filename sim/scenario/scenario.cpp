#include "sim/scenario/scenario.h"

#include <array>
#include <string_view>

#include "sim/rules/toml_table.h"

namespace eod::sim {
namespace {

constexpr std::array<std::string_view, 14> kScenarioKeys = {
    "name", "title", "module",  "difficulty", "par_time_s", "time_limit_s", "seed",
    "step", "start", "weather", "link",       "score",      "place",        "fault"};
constexpr std::array<std::string_view, 3> kWeatherKeys = {"light", "visibility_m", "rain_mm_per_h"};
constexpr std::array<std::string_view, 3> kLights = {"day", "dusk", "night"};  // as the enum

constexpr double kMaxTime = 86400;  // [s]

Weather ReadWeather(const TomlTable& table) {
  table.RejectUnknownKeys(kWeatherKeys);
  return {.light = static_cast<Weather::Light>(table.Choice("light", kLights, 0)),
          .visibility = table.Number("visibility_m", 5, 10000, 0.0),
          .rain = table.Number("rain_mm_per_h", 0, 50, 0.0)};
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
  if (table.Has("start")) scenario.start = ReadPlacement(table.Table("start"), false);
  if (table.Has("weather")) scenario.weather = ReadWeather(table.Table("weather"));
  if (table.Has("link")) scenario.link = ReadControlLinkSpec(table.Table("link"));
  if (table.Has("score")) scenario.rubric = ReadRubric(table.Table("score"));
  for (const TomlTable& place : table.Tables("place")) {
    scenario.places.push_back(ReadPlacement(place, true));
  }
  for (const TomlTable& step : table.Tables("step")) scenario.steps.push_back(ReadTaskStep(step));
  for (const TomlTable& fault : table.Tables("fault")) {
    scenario.faults.push_back(ReadFaultSpec(fault));
  }
  return scenario;
}

}  // namespace eod::sim
