#include "sim/scenario/placement.h"

#include <numbers>
#include <string_view>

#include "sim/rules/toml_table.h"

namespace eod::sim {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;
constexpr double kMaxLength = 3000;  // [m] the whole world

}  // namespace

Placement ReadPlacement(const TomlTable& table, bool names_object) {
  using Keys = std::vector<std::string_view>;
  Keys keys{"position_m", "heading_deg", "spread_m", "spread_deg"};
  if (names_object) keys.emplace_back("object");
  table.RejectUnknownKeys(keys);
  Placement place;
  if (names_object) place.object = table.Text("object");
  place.line = table.LineOf("object");
  const std::vector<double> position = table.Numbers("position_m", 3, -kMaxLength, kMaxLength);
  if (!position.empty()) place.position = Eigen::Vector3d(position.data());
  if (table.Has("heading_deg")) {
    place.heading = table.Number("heading_deg", -360, 360) * kRadiansPerDegree;
  }
  const std::vector<double> spread = table.Numbers("spread_m", 2, 0, 100);
  if (!spread.empty()) place.spread.head<2>() = Eigen::Vector2d(spread.data());
  place.spread.z() = table.Number("spread_deg", 0, 180, 0.0) * kRadiansPerDegree;
  return place;
}

}  // namespace eod::sim
