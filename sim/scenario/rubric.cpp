#include "sim/scenario/rubric.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "sim/rules/toml_table.h"

namespace eod::sim {
namespace {

constexpr std::array<std::string_view, 7> kRubricKeys = {"steps",   "safety", "precision", "time",
                                                         "economy", "pass",   "tilt_deg"};

}  // namespace

Rubric ReadRubric(const TomlTable& table) {
  table.RejectUnknownKeys(kRubricKeys);
  Rubric rubric;
  rubric.steps = table.Number("steps", 0, 100, rubric.steps);
  rubric.safety = table.Number("safety", 0, 100, rubric.safety);
  rubric.precision = table.Number("precision", 0, 100, rubric.precision);
  rubric.time = table.Number("time", 0, 100, rubric.time);
  rubric.economy = table.Number("economy", 0, 100, rubric.economy);
  rubric.pass = table.Number("pass", 0, 100, rubric.pass);
  rubric.tilt = table.Number("tilt_deg", 1, 90, 0.0) * std::numbers::pi / 180;
  const double sum = rubric.steps + rubric.safety + rubric.precision + rubric.time + rubric.economy;
  if (std::abs(sum - 100) > 1e-9) {
    table.Fail(table.line(), fmt::format("steps, safety, precision, time and economy add up to {}, "
                                         "allowed 100",
                                         sum));
  }
  return rubric;
}

}  // namespace eod::sim
