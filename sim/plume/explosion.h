#pragma once

#include <cstdint>
#include <span>

#include <Eigen/Core>

#include "sim/plume/picture_effects.h"
#include "sim/plume/plume.h"
#include "sim/plume/plume_quad.h"
#include "sim/rules/explosion_rules.h"

namespace eod::sim {

/// A charge that goes off, as the cameras show it: a flash of two pictures, a fireball, smoke that
/// the wind carries away, cameras that shake; and noise in place of pictures if the robot was
/// destroyed. Nothing here has a part in the exercise. Deterministic; steps allocate nothing.
class Explosion {
 public:
  explicit Explosion(const ExplosionRules& rules);

  /// Goes off at `p_MD` on the ground below the charge [m]; a former one is forgotten.
  /// `robot_destroyed`: the feeds fade to noise behind the flash, and stay so until Reset.
  void Ignite(const Eigen::Vector3d& p_MD, uint32_t seed, bool robot_destroyed);
  void Step(double dt_s);
  /// Clear air, and pictures again.
  void Reset();

  /// In the module's frame, in no order. Valid until the next call.
  std::span<const PlumeQuad> quads() const { return plume_.quads(); }
  const PictureEffects& effects() const { return effects_; }
  const Plume& plume() const { return plume_; }

 private:
  void UpdateEffects();

  ExplosionRules rules_;
  Plume plume_;
  PlumeSource source_;
  bool is_burning_ = false;  ///< from ignition until the last smoke is gone
  bool robot_destroyed_ = false;
  double time_ = 0;  ///< [s] since ignition
  PlumeRandom random_;
  PictureEffects effects_;
};

}  // namespace eod::sim
