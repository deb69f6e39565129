#pragma once

#include "sim/plume/plume.h"
#include "sim/rules/rules.h"

namespace eod::sim {

inline const ExplosionRules& TheExplosion() {
  static const Rules rules = LoadRules(EOD_DATA_DIR "/sim/rules/eod_rules.toml");
  return rules.explosion;
}

inline PlumeAir TheAir(const Eigen::Vector3d& wind = TheExplosion().wind) {
  return {.wind = wind,
          .buoyancy = TheExplosion().buoyancy,
          .cooling_time = TheExplosion().cooling_time,
          .drag = TheExplosion().drag};
}

constexpr double kStep = 0.004;  // [s] as the simulator's

/// A fire at the origin that glows and smokes, fed as fast as its particles die.
inline PlumeSource SmokingFire(int count) {
  PlumeSource source{.radius = TheExplosion().source_radius, .puff = TheExplosion().smoke_puff};
  source.puff.flame = TheExplosion().fireball;
  source.rate = 2 * count / (source.puff.life_min + source.puff.life_max);
  return source;
}

inline void Burn(double seconds, Plume& plume) {
  for (double t = 0; t < seconds; t += kStep) plume.Step(kStep);
}

/// The fire after it burnt for `seconds`.
inline Plume Burning(int count, double seconds, const PlumeAir& air = TheAir(), uint32_t seed = 1) {
  Plume plume(count, air);
  plume.Reset(seed);
  plume.Light(SmokingFire(count));
  Burn(seconds, plume);
  return plume;
}

}  // namespace eod::sim
