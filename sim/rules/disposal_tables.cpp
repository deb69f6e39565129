#include "sim/rules/disposal_tables.h"

#include <array>
#include <numbers>
#include <string_view>

namespace eod::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

double Angle(const TomlTable& table, std::string_view key) {
  return table.Number(key, 0.1, 90) * kDegree;
}
double Length(const TomlTable& table, std::string_view key) {
  return table.Number(key, 0.0001, 100);
}
double Seconds(const TomlTable& table, std::string_view key) {
  return table.Number(key, 0.01, 600);
}
double Speed(const TomlTable& table, std::string_view key) { return table.Number(key, 0.001, 10); }

}  // namespace

GraspRules ReadGrasp(const TomlTable& table) {
  constexpr std::array<std::string_view, 13> kKeys = {
      "pad_m",         "pad_half_height_m", "surface_tolerance_m",
      "opposed_below", "across_deg",        "relative_speed_mps",
      "tilt_deg",      "close_memory_s",    "steps",
      "release_m",     "squeeze_s",         "slip_mps",
      "slip_s"};
  table.RejectUnknownKeys(kKeys);
  return {.pad = Length(table, "pad_m"),
          .pad_half_height = Length(table, "pad_half_height_m"),
          .surface_tolerance = Length(table, "surface_tolerance_m"),
          .opposed_below = table.Number("opposed_below", -1, 0),
          .across = Angle(table, "across_deg"),
          .relative_speed = Speed(table, "relative_speed_mps"),
          .tilt = Angle(table, "tilt_deg"),
          .close_memory = Seconds(table, "close_memory_s"),
          .steps = static_cast<int>(table.Integer("steps", 1, 1000)),
          .release = Length(table, "release_m"),
          .squeeze = Seconds(table, "squeeze_s"),
          .slip_speed = Speed(table, "slip_mps"),
          .slip = Seconds(table, "slip_s")};
}

ChargeRules ReadCharge(const TomlTable& table) {
  constexpr std::array<std::string_view, 9> kKeys = {
      "disturbed_deg", "unstable_deg", "drop_m",       "lethal_m",     "push_through_s",
      "push_share",    "carried_m",    "probe_skin_m", "probe_inset_m"};
  table.RejectUnknownKeys(kKeys);
  return {.disturbed = Angle(table, "disturbed_deg"),
          .unstable = Angle(table, "unstable_deg"),
          .drop = Length(table, "drop_m"),
          .lethal = Length(table, "lethal_m"),
          .push_through = Seconds(table, "push_through_s"),
          .push_share = table.Number("push_share", 0.01, 1),
          .carried = Length(table, "carried_m"),
          .probe_skin = Length(table, "probe_skin_m"),
          .probe_inset = Length(table, "probe_inset_m")};
}

VesselRules ReadVessel(const TomlTable& table) {
  constexpr std::array<std::string_view, 2> kKeys = {"rim_strike_mps", "net_sag_m"};
  table.RejectUnknownKeys(kKeys);
  return {.rim_strike = Speed(table, "rim_strike_mps"), .net_sag = Length(table, "net_sag_m")};
}

DisrupterRules ReadDisrupter(const TomlTable& table) {
  constexpr std::array<std::string_view, 13> kKeys = {
      "arm_s",        "both_within_s", "hold_s",      "time_out_s",  "muzzle_x_m",
      "muzzle_y_m",   "muzzle_z_m",    "min_range_m", "max_range_m", "reach_m",
      "aim_offset_m", "aim_angle_deg", "impulse_ns"};
  table.RejectUnknownKeys(kKeys);
  const double min_range = Length(table, "min_range_m");
  const double max_range = table.Number("max_range_m", min_range, 100);
  return {.arm = Seconds(table, "arm_s"),
          .both_within = Seconds(table, "both_within_s"),
          .hold = Seconds(table, "hold_s"),
          .time_out = Seconds(table, "time_out_s"),
          .muzzle = {table.Number("muzzle_x_m", -1, 1), table.Number("muzzle_y_m", -1, 1),
                     table.Number("muzzle_z_m", -1, 1)},
          .min_range = min_range,
          .max_range = max_range,
          .reach = table.Number("reach_m", max_range, 100),
          .aim_offset = Length(table, "aim_offset_m"),
          .aim_angle = Angle(table, "aim_angle_deg"),
          .impulse = table.Number("impulse_ns", 0, 100)};
}

}  // namespace eod::sim
