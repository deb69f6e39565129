#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "sim/plume/plume_quad.h"
#include "sim/plume/plume_random.h"
#include "sim/rules/explosion_rules.h"

namespace eod::sim {

/// One textured particle of a plume, in the module's frame.
struct PlumeParticle {
  Eigen::Vector3d p_M = Eigen::Vector3d::Zero();     ///< [m]
  Eigen::Vector3d v_M = Eigen::Vector3d::Zero();     ///< [m/s]
  Eigen::Vector3d colour = Eigen::Vector3d::Zero();  ///< linear 0..1, brightness not counted in
  double brightness = 0;                             ///< multiplies the colour
  double half_size = 0;                              ///< [m]
  double age = 0;                                    ///< [s]
  double life = 0;                                   ///< [s]
  double angle = 0;                                  ///< [rad]
  double spin = 0;                                   ///< [rad/s]
  bool is_alive = false;
  PuffRules puff;  ///< what it was born as
};

/// Where particles are born: a level disc, on ground that they do not sink into.
struct PlumeSource {
  Eigen::Vector3d p_MS = Eigen::Vector3d::Zero();  ///< [m]
  double radius = 0;                               ///< [m]
  double rate = 0;                                 ///< [1/s] births, as far as there is room
  PuffRules puff;
};

/// The air around: it carries off, lifts and slows down.
struct PlumeAir {
  Eigen::Vector3d wind = Eigen::Vector3d::Zero();  ///< [m/s]
  double buoyancy = 0;                             ///< [m/s^2] of a fresh particle
  double cooling_time = 1;                         ///< [s] in which it falls to 37 %
  double drag = 0;                                 ///< [1/s]
};

/// A plume of few large textured particles in place of thousands of points, as the source paper's
/// neighbour has it (domain, section 7). Each goes from white over yellow, orange and grey to
/// black, where it dies. Deterministic: same seed and steps, same bits. Steps allocate nothing.
class Plume {
 public:
  /// At most `count` >= 1 particles are alive at a time.
  Plume(int count, const PlumeAir& air);

  /// From now on particles are born here; who lives goes on.
  void Light(const PlumeSource& source) { source_ = source; }
  /// Births at once, as far as there is room, whatever the source's rate.
  void Burst(int births);
  /// No more births.
  void Extinguish() { source_.rate = 0; }
  /// Empty and dark, and the random numbers from the start.
  void Reset(uint32_t seed);
  void Step(double dt_s);

  std::span<const PlumeParticle> particles() const { return particles_; }
  /// Those that are alive, in no order.
  std::span<const PlumeQuad> quads() const { return quads_; }
  int alive() const { return static_cast<int>(quads_.size()); }
  /// Mean of R, G and B over the greatest number of particles; the dead count as black.
  double mean_brightness() const;
  /// Mean place of those alive; zero without any.
  Eigen::Vector3d centroid() const;

 private:
  void Bear(PlumeParticle& particle);
  void Move(PlumeParticle& particle, double dt_s) const;
  void WriteQuads();

  PlumeAir air_;
  PlumeSource source_;
  PlumeRandom random_;
  double births_owed_ = 0;
  std::vector<PlumeParticle> particles_;
  std::vector<PlumeQuad> quads_;
};

}  // namespace eod::sim
