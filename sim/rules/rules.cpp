#include "sim/rules/rules.h"

#include <array>
#include <numbers>
#include <string_view>

#include "sim/rules/disposal_tables.h"
#include "sim/rules/toml_table.h"

namespace eod::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr std::array<std::string_view, 6> kTables = {"tilt",   "grasp",     "charge",
                                                     "vessel", "disrupter", "explosion"};

TiltRules ReadTilt(const TomlTable& table) {
  constexpr std::array<std::string_view, 2> kKeys = {"alarm_deg", "rollover_deg"};
  table.RejectUnknownKeys(kKeys);
  return {.alarm = table.Number("alarm_deg", 1, 90) * kDegree,
          .rollover = table.Number("rollover_deg", 1, 90) * kDegree};
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
          .explosion = ReadExplosion(table.Table("explosion"))};
}

}  // namespace eod::sim
