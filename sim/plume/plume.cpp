#include "sim/plume/plume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace eod::sim {
namespace {

using Eigen::Vector3d;

constexpr double kBlack = 0.05;        // dead below, max(R, G, B) (domain, section 7)
constexpr double kFadeIn = 0.25;       // [s] smoke does not jump into the picture
constexpr double kFlameDensity = 0.3;  // of flame, whose lights add up, against smoke
constexpr double kFadeOut = 0.55;      // share of the life from which on it thins out
constexpr double kGroundGap = 0.6;     // share of its half size that a puff keeps from the ground

struct RampStop {
  double at;
  Vector3d colour;
};

/// Mean brightness falls along both ramps, and from one to the other.
const std::array<RampStop, 3> kFlame{{{0.0, Vector3d(1.0, 0.95, 0.80)},
                                      {0.3, Vector3d(1.0, 0.64, 0.12)},
                                      {1.0, Vector3d(0.78, 0.17, 0.012)}}};
const std::array<RampStop, 4> kSmoke{{{0.0, Vector3d(0.24, 0.215, 0.19)},
                                      {0.5, Vector3d(0.15, 0.142, 0.135)},
                                      {0.9, Vector3d(0.07, 0.068, 0.066)},
                                      {1.0, Vector3d(0.0, 0.0, 0.0)}}};
constexpr double kGlowsOut = 0.6;  // share of the flame's time from which on it turns grey

template <size_t kStops>
Vector3d Along(const std::array<RampStop, kStops>& ramp, double at) {
  for (size_t i = 1; i < kStops; ++i) {
    if (at > ramp[i].at) continue;
    const double share = (at - ramp[i - 1].at) / (ramp[i].at - ramp[i - 1].at);
    return ramp[i - 1].colour + share * (ramp[i].colour - ramp[i - 1].colour);
  }
  return ramp.back().colour;
}

/// 0: flame; 1: smoke.
double SmokeShare(const PlumeParticle& particle) {
  if (particle.puff.flame <= 0) return 1;
  const double glowed = particle.age / particle.puff.flame;
  return std::clamp((glowed - kGlowsOut) / (1 - kGlowsOut), 0.0, 1.0);
}

Vector3d ColourOf(const PlumeParticle& particle) {
  const double share = SmokeShare(particle);
  const Vector3d smoke = Along(kSmoke, particle.age / particle.life);
  if (share >= 1) return smoke;
  return (1 - share) * Along(kFlame, particle.age / particle.puff.flame) + share * smoke;
}

double AlphaOf(const PlumeParticle& particle) {
  const double share = particle.age / particle.life;
  const double left = std::clamp((1 - share) / (1 - kFadeOut), 0.0, 1.0);
  const double grown = particle.puff.flame > 0 ? 1 : std::min(1.0, particle.age / kFadeIn);
  const double density = kFlameDensity + (1 - kFlameDensity) * SmokeShare(particle);
  return particle.puff.opacity * density * grown * left;
}

/// Lowest place of a puff's centre: it spreads over the ground, it does not sink into it.
double Floor(const PlumeSource& source, double half_size) {
  return source.p_MS.z() + kGroundGap * half_size;
}

}  // namespace

Plume::Plume(int count, const PlumeAir& air) : air_(air) {
  particles_.resize(static_cast<size_t>(count));
  quads_.reserve(particles_.size());
}

void Plume::Reset(uint32_t seed) {
  random_ = PlumeRandom(seed);
  source_ = {};
  births_owed_ = 0;
  for (PlumeParticle& particle : particles_) particle.is_alive = false;
  quads_.clear();
}

void Plume::Burst(int births) {
  for (PlumeParticle& particle : particles_) {
    if (births == 0) break;
    if (particle.is_alive) continue;
    Bear(particle);
    --births;
  }
  WriteQuads();
}

void Plume::Step(double dt_s) {
  births_owed_ += source_.rate * dt_s;
  for (PlumeParticle& particle : particles_) {
    if (particle.is_alive) Move(particle, dt_s);
    if (particle.is_alive || births_owed_ < 1) continue;
    births_owed_ -= 1;
    Bear(particle);
  }
  // What found no room is not made up for.
  births_owed_ = std::min(births_owed_, 1.0);
  WriteQuads();
}

void Plume::Bear(PlumeParticle& particle) {
  const PuffRules& puff = source_.puff;
  const double turn = random_.Uniform(0, 2 * std::numbers::pi);
  // The square root spreads evenly over the disc.
  const double out = std::sqrt(random_.Uniform(0, 1));
  const Vector3d radial(std::cos(turn), std::sin(turn), 0);
  particle.puff = puff;
  particle.age = 0;
  particle.life = random_.Uniform(puff.life_min, puff.life_max);
  particle.half_size = puff.half_size_start;
  particle.p_M = source_.p_MS + source_.radius * out * radial;
  particle.p_M.z() = Floor(source_, particle.half_size);
  particle.v_M = air_.wind + puff.speed_out * out * random_.Uniform(0.5, 1) * radial;
  // What flies outwards does not rise as fast.
  particle.v_M.z() = puff.speed_up * random_.Uniform(0.3, 1) * (1 - 0.6 * out);
  particle.angle = random_.Uniform(0, 2 * std::numbers::pi);
  particle.spin = random_.Uniform(-0.5, 0.5);
  particle.brightness = random_.Uniform(0.8, 1);
  particle.colour = ColourOf(particle);
  particle.is_alive = true;
}

void Plume::Move(PlumeParticle& particle, double dt_s) const {
  const PuffRules& puff = particle.puff;
  particle.age += dt_s;
  const double lift = air_.buoyancy * std::exp(-particle.age / air_.cooling_time);
  particle.v_M += dt_s * (air_.drag * (air_.wind - particle.v_M) + lift * Vector3d::UnitZ());
  particle.p_M += dt_s * particle.v_M;
  particle.half_size += dt_s / puff.growth_time * (puff.half_size_end - particle.half_size);
  particle.p_M.z() = std::max(particle.p_M.z(), Floor(source_, particle.half_size));
  particle.angle += dt_s * particle.spin;
  particle.colour = ColourOf(particle);
  const bool is_black = particle.brightness * particle.colour.maxCoeff() < kBlack;
  particle.is_alive = !is_black && particle.age <= particle.life;
}

void Plume::WriteQuads() {
  quads_.clear();
  for (const PlumeParticle& particle : particles_) {
    if (!particle.is_alive) continue;
    quads_.push_back({.p_M = particle.p_M.cast<float>(),
                      .half_size = static_cast<float>(particle.half_size),
                      .colour = (particle.brightness * particle.colour).cast<float>(),
                      .alpha = static_cast<float>(AlphaOf(particle)),
                      .angle = static_cast<float>(particle.angle),
                      .cover = static_cast<float>(SmokeShare(particle))});
  }
}

double Plume::mean_brightness() const {
  double sum = 0;
  for (const PlumeQuad& quad : quads_) sum += static_cast<double>(quad.colour.mean());
  return sum / static_cast<double>(particles_.size());
}

Vector3d Plume::centroid() const {
  Vector3d sum = Vector3d::Zero();
  for (const PlumeQuad& quad : quads_) sum += quad.p_M.cast<double>();
  return quads_.empty() ? sum : Vector3d(sum / static_cast<double>(quads_.size()));
}

}  // namespace eod::sim
