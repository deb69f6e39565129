#include "sim/rules/explosion_rules.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <string_view>

#include "sim/rules/toml_table.h"

namespace eod::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kMostQuads = 32;  // of the source paper

PuffRules ReadPuff(const TomlTable& table, double flame, double longest_life) {
  constexpr std::array<std::string_view, 8> kKeys = {
      "speed_out_mps",     "speed_up_mps",    "life_min_s",    "life_max_s",
      "half_size_start_m", "half_size_end_m", "growth_time_s", "opacity"};
  table.RejectUnknownKeys(kKeys);
  PuffRules puff;
  puff.flame = flame;
  puff.speed_out = table.Number("speed_out_mps", 0, 50);
  puff.speed_up = table.Number("speed_up_mps", 0, 50);
  puff.life_max = table.Number("life_max_s", std::max(0.1, flame), longest_life);
  puff.life_min = table.Number("life_min_s", std::max(0.1, flame), puff.life_max);
  puff.half_size_end = table.Number("half_size_end_m", 0.01, 20);
  puff.half_size_start = table.Number("half_size_start_m", 0.01, puff.half_size_end);
  puff.growth_time = table.Number("growth_time_s", 0.01, 20);
  puff.opacity = table.Number("opacity", 0, 1);
  return puff;
}

}  // namespace

ExplosionRules ReadExplosion(const TomlTable& table) {
  constexpr std::array<std::string_view, 16> kKeys = {
      "quads",           "flash_s",       "fireball_s",     "smoke_s",
      "smoke_source_s",  "shake_deg",     "shake_decay_s",  "noise_ramp_s",
      "source_radius_m", "wind_east_mps", "wind_north_mps", "buoyancy_mps2",
      "cooling_time_s",  "drag_per_s",    "fire",           "smoke"};
  table.RejectUnknownKeys(kKeys);
  ExplosionRules rules;
  rules.quads = static_cast<int>(table.Integer("quads", 1, kMostQuads));
  rules.flash = table.Number("flash_s", 0, 1);
  rules.fireball = table.Number("fireball_s", 0.05, 5);
  rules.smoke = table.Number("smoke_s", rules.fireball, 60);
  rules.smoke_source = table.Number("smoke_source_s", 0, rules.smoke);
  rules.shake = table.Number("shake_deg", 0, 10) * kDegree;
  rules.shake_decay = table.Number("shake_decay_s", 0.01, 10);
  rules.noise_ramp = table.Number("noise_ramp_s", 0.01, 10);
  rules.source_radius = table.Number("source_radius_m", 0, 5);
  rules.wind = {table.Number("wind_east_mps", -20, 20), table.Number("wind_north_mps", -20, 20), 0};
  rules.buoyancy = table.Number("buoyancy_mps2", 0, 50);
  rules.cooling_time = table.Number("cooling_time_s", 0.01, 60);
  rules.drag = table.Number("drag_per_s", 0, 50);
  rules.fire = ReadPuff(table.Table("fire"), rules.fireball, rules.smoke);
  // What the crater gives last has to be gone in time.
  rules.smoke_puff = ReadPuff(table.Table("smoke"), 0, rules.smoke - rules.smoke_source);
  return rules;
}

}  // namespace eod::sim
