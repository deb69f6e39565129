#pragma once

#include <algorithm>

#include <Eigen/Core>

#include "sim/world/weather.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// What the sky's panorama is painted from. Colours as a picture holds them: square roots of linear
/// ones.
struct SkyLook {
  Eigen::Vector3f to_light = Eigen::Vector3f::Zero();  ///< towards sun or moon, unit
  Eigen::Vector3f disc = Eigen::Vector3f::Zero();      ///< colour of its disc
  Eigen::Vector3f glow = Eigen::Vector3f::Zero();      ///< added around it, most near the horizon
  Eigen::Vector3f horizon = Eigen::Vector3f::Zero();   ///< the fog's colour
  Eigen::Vector3f zenith = Eigen::Vector3f::Zero();
  Eigen::Vector3f cloud_lit = Eigen::Vector3f::Zero();
  Eigen::Vector3f cloud_shade = Eigen::Vector3f::Zero();
  float hills = 1;     ///< brightness of hills and trees against a clear day's
  float overcast = 0;  ///< share of the sky behind even cloud, 0..1
  float haze = 0;      ///< share of fog over all that is far away, 0..1
  float stars = 0;     ///< brightness of the brightest
  bool operator==(const SkyLook&) const = default;
};

/// Light and air of a picture. Light is linear: 1 on a white surface gives a picture's white.
struct Lighting {
  Eigen::Vector3f to_sun = Eigen::Vector3f::Zero();     ///< towards sun or moon, unit
  Eigen::Vector3f sun_light = Eigen::Vector3f::Zero();  ///< on a surface that faces it
  Eigen::Vector3f sky_light =
      Eigen::Vector3f::Zero();  ///< on a surface that looks up, under the open sky
  Eigen::Vector3f ground_light = Eigen::Vector3f::Zero();  ///< on one that looks down
  Eigen::Vector3f fog_colour = Eigen::Vector3f::Zero();    ///< as a picture holds it
  float fog_density = 0;      ///< [1/m] exp(-density d) of the contrast is left at distance d
  float wetness = 0;          ///< of what lies under the open sky, 0..1
  bool street_lamps = false;  ///< those under the open sky are lit
  SkyLook sky;

  /// On level ground under the open sky, in the sun, mean of the channels.
  float OnOpenGround() const { return (sky_light + std::max(to_sun.z(), 0.0F) * sun_light).mean(); }
};

/// `air` is the world's on a clear day. Visibility V is where 5 % of the contrast are left: density
/// ln(20) / V (Koschmieder 1924). Without it, rain of R [mm/h] takes 1.076 R^0.67 dB/km (Carbonneau
/// and Wisely 1998) beyond what the world's own air takes.
Lighting LightingOf(const Atmosphere& air, const Weather& weather);

}  // namespace eod::sim
