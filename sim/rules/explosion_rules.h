#pragma once

#include <Eigen/Core>

namespace eod::sim {

class TomlTable;

/// How one kind of particle of an explosion is born and ages.
struct PuffRules {
  double speed_out = 0;        ///< [m/s] fastest away from the source's axis
  double speed_up = 0;         ///< [m/s] fastest upwards
  double flame = 0;            ///< [s] it glows so long; 0: smoke from the beginning
  double life_min = 0;         ///< [s]
  double life_max = 0;         ///< [s]
  double half_size_start = 0;  ///< [m]
  double half_size_end = 0;    ///< [m] what it grows to
  double growth_time = 0;      ///< [s] until 63 % of that growth
  double opacity = 0;          ///< 0..1 of one puff at its densest
};

/// Section [explosion] of the exercise's rules.
struct ExplosionRules {
  int quads = 0;             ///< at most so many particles at a time
  double flash = 0;          ///< [s]
  double fireball = 0;       ///< [s]
  double smoke = 0;          ///< [s] from ignition until the last smoke is gone
  double smoke_source = 0;   ///< [s] so long the crater goes on smoking
  double shake = 0;          ///< [rad]
  double shake_decay = 0;    ///< [s] to 37 %
  double noise_ramp = 0;     ///< [s] in which the feeds of a destroyed robot fade to noise
  double source_radius = 0;  ///< [m] of the disc
  Eigen::Vector3d wind = Eigen::Vector3d::Zero();  ///< [m/s] where it blows to
  double buoyancy = 0;                             ///< [m/s^2] of fresh gas
  double cooling_time = 0;                         ///< [s] in which that falls to 37 %
  double drag = 0;                                 ///< [1/s] share of the speed lost to the air
  PuffRules fire;
  PuffRules smoke_puff;
};

/// Reads the section. Throws std::runtime_error with one line "FILE:LINE: …".
ExplosionRules ReadExplosion(const TomlTable& table);

}  // namespace eod::sim
