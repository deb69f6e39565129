#include "sim/rules/rules.h"

#include <array>
#include <numbers>
#include <string_view>

#include "sim/rules/disposal_tables.h"
#include "sim/rules/toml_table.h"

namespace eod::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr std::array<std::string_view, 9> kTables = {
    "tilt", "grasp", "charge", "vessel", "disrupter", "explosion", "score", "critical", "link"};

TiltRules ReadTilt(const TomlTable& table) {
  constexpr std::array<std::string_view, 2> kKeys = {"alarm_deg", "rollover_deg"};
  table.RejectUnknownKeys(kKeys);
  return {.alarm = table.Number("alarm_deg", 1, 90) * kDegree,
          .rollover = table.Number("rollover_deg", 1, 90) * kDegree};
}

CriticalRules ReadCritical(const TomlTable& table) {
  constexpr std::array<std::string_view, 2> kKeys = {"link_lost_s", "bomb_below_m"};
  table.RejectUnknownKeys(kKeys);
  return {.link_lost = table.Number("link_lost_s", 0.5, 3600),
          .bomb_below = table.Number("bomb_below_m", -1000, 0)};
}

LinkRules ReadLink(const TomlTable& table) {
  constexpr std::array<std::string_view, 5> kKeys = {
      "check_period_s", "base_antenna_m", "robot_antenna_m", "drop_below", "cable_height_m"};
  table.RejectUnknownKeys(kKeys);
  return {.check_period = table.Number("check_period_s", 0.02, 2),
          .base_antenna = table.Number("base_antenna_m", 0.1, 20),
          .robot_antenna = table.Number("robot_antenna_m", 0.1, 5),
          .drop_below = table.Number("drop_below", 0.01, 1),
          .cable_height = table.Number("cable_height_m", 0.05, 1)};
}

}  // namespace

Rules LoadRules(const std::filesystem::path& file) {
  const toml::table parsed = ParseToml(file, "rules");
  const TomlTable table(file, parsed);
  table.RejectUnknownKeys(kTables);
  return {.file = file,
          .tilt = ReadTilt(table.Table("tilt")),
          .grasp = ReadGrasp(table.Table("grasp")),
          .charge = ReadCharge(table.Table("charge")),
          .vessel = ReadVessel(table.Table("vessel")),
          .disrupter = ReadDisrupter(table.Table("disrupter")),
          .explosion = ReadExplosion(table.Table("explosion")),
          .score = ReadScoreRules(table.Table("score")),
          .critical = ReadCritical(table.Table("critical")),
          .link = ReadLink(table.Table("link"))};
}

}  // namespace eod::sim
