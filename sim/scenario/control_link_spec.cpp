#include "sim/scenario/control_link_spec.h"

#include <array>
#include <string>
#include <string_view>

#include "sim/rules/toml_table.h"

namespace eod::sim {
namespace {

constexpr std::array<std::string_view, 8> kLinkKeys = {
    "kind", "base_m", "range_m", "wall_loss", "cable_m", "commands", "telemetry", "pictures"};
constexpr std::array<std::string_view, 3> kTrafficKeys = {"delay_ms", "jitter_ms", "loss"};
constexpr std::array<std::string_view, 3> kKinds = {"ideal", "radio", "cable"};  // as the enum

TrafficSpec ReadTraffic(const TomlTable& link, std::string_view key) {
  if (!link.Has(key)) return {};
  const TomlTable table = link.Table(key);
  table.RejectUnknownKeys(kTrafficKeys);
  return {.delay = table.Number("delay_ms", 0, 500, 0.0) / 1000,
          .jitter = table.Number("jitter_ms", 0, 500, 0.0) / 1000,
          .loss = table.Number("loss", 0, 1, 0.0)};
}

}  // namespace

ControlLinkSpec ReadControlLinkSpec(const TomlTable& table) {
  table.RejectUnknownKeys(kLinkKeys);
  ControlLinkSpec link;
  link.kind = static_cast<ControlLinkSpec::Kind>(table.Choice("kind", kKinds, 0));
  const std::vector<double> base = table.Numbers("base_m", 2, -3000, 3000);
  if (!base.empty()) link.base = Eigen::Vector2d(base[0], base[1]);
  link.range = table.Number("range_m", 1, 5000, link.range);
  link.wall_loss = table.Number("wall_loss", 0, 1, link.wall_loss);
  link.cable_length = table.Number("cable_m", 1, 500, link.cable_length);
  link.commands = ReadTraffic(table, "commands");
  link.telemetry = ReadTraffic(table, "telemetry");
  link.pictures = ReadTraffic(table, "pictures");
  return link;
}

}  // namespace eod::sim
