#include "sim/rules/score_rules.h"

#include <array>
#include <numbers>
#include <string_view>

#include "sim/rules/toml_table.h"

namespace eod::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr std::array<std::string_view, 21> kKeys = {
    "collision_points",    "push_points_per_s", "push_grace_s",   "tilt_points",
    "tilt_hysteresis_deg", "touch_points",      "touch_memory_s", "fire_points",
    "unseen_points",       "unseen_way_m",      "view_pan_deg",   "procedure_points",
    "time_zero_pars",      "reversal_points",   "reversal_s",     "undone_points",
    "undone_share",        "undone_deg",        "limit_points",   "travel_reach_m",
    "travel_slack_m"};

double Points(const TomlTable& table, std::string_view key) { return table.Number(key, 0, 100); }

}  // namespace

ScoreRules ReadScoreRules(const TomlTable& table) {
  table.RejectUnknownKeys(kKeys);
  return {.collision_points = Points(table, "collision_points"),
          .push_points = Points(table, "push_points_per_s"),
          .push_grace = table.Number("push_grace_s", 0, 60),
          .tilt_points = Points(table, "tilt_points"),
          .tilt_hysteresis = table.Number("tilt_hysteresis_deg", 0, 180) * kDegree,
          .touch_points = Points(table, "touch_points"),
          .touch_memory = table.Number("touch_memory_s", 0, 60),
          .fire_points = Points(table, "fire_points"),
          .unseen_points = Points(table, "unseen_points"),
          .unseen_way = table.Number("unseen_way_m", 0, 100),
          .view_pan = table.Number("view_pan_deg", 0, 180) * kDegree,
          .procedure_points = Points(table, "procedure_points"),
          .time_zero = table.Number("time_zero_pars", 1.01, 100),
          .reversal_points = Points(table, "reversal_points"),
          .reversal_time = table.Number("reversal_s", 0, 60),
          .undone_points = Points(table, "undone_points"),
          .undone_share = table.Number("undone_share", 0.1, 1),
          .undone_angle = table.Number("undone_deg", 0, 180) * kDegree,
          .limit_points = Points(table, "limit_points"),
          .travel_reach = table.Number("travel_reach_m", 0, 100),
          .travel_slack = table.Number("travel_slack_m", 0, 100)};
}

}  // namespace eod::sim
