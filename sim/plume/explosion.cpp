#include "sim/plume/explosion.h"

#include <algorithm>
#include <cmath>

namespace eod::sim {
namespace {

constexpr double kStill = 1e-3;  // [rad] a shake that nobody sees

/// Of all particles, the share that the charge throws out at once.
int FireCount(const ExplosionRules& rules) { return (rules.quads + 1) / 2; }

PlumeAir AirOf(const ExplosionRules& rules) {
  return {.wind = rules.wind,
          .buoyancy = rules.buoyancy,
          .cooling_time = rules.cooling_time,
          .drag = rules.drag};
}

}  // namespace

Explosion::Explosion(const ExplosionRules& rules)
    : rules_(rules), plume_(rules.quads, AirOf(rules)) {}

void Explosion::Ignite(const Eigen::Vector3d& p_MD, uint32_t seed, bool robot_destroyed) {
  Reset();
  plume_.Reset(seed);
  random_ = PlumeRandom(~seed);
  is_burning_ = true;
  robot_destroyed_ = robot_destroyed;
  source_ = {.p_MS = p_MD, .radius = rules_.source_radius, .rate = 0, .puff = rules_.fire};
  plume_.Light(source_);
  plume_.Burst(FireCount(rules_));
  // The crater smokes through the particles that the fireball leaves over, and those it frees.
  source_.puff = rules_.smoke_puff;
  source_.rate = rules_.quads / rules_.smoke_puff.life_max;
  UpdateEffects();
}

void Explosion::Reset() {
  plume_.Reset(0);
  is_burning_ = false;
  robot_destroyed_ = false;
  time_ = 0;
  effects_ = {};
}

void Explosion::Step(double dt_s) {
  if (!is_burning_ && !robot_destroyed_) return;
  time_ += dt_s;
  if (is_burning_) {
    PlumeSource source = source_;
    if (time_ < rules_.fireball || time_ > rules_.smoke_source) source.rate = 0;
    plume_.Light(source);
    plume_.Step(dt_s);
    is_burning_ = time_ < rules_.smoke;
    if (!is_burning_) plume_.Reset(0);
  }
  UpdateEffects();
}

void Explosion::UpdateEffects() {
  effects_ = {};
  const auto share = [](double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); };
  if (time_ < rules_.flash) effects_.flash = share(1 - std::pow(time_ / rules_.flash, 3));
  const double shake = rules_.shake * std::exp(-time_ / rules_.shake_decay);
  if (shake > kStill) effects_.shake = static_cast<float>(shake);
  if (robot_destroyed_) effects_.noise = share((time_ - rules_.flash) / rules_.noise_ramp);
  if (effects_ != PictureEffects{}) effects_.seed = random_.Next();
}

}  // namespace eod::sim
