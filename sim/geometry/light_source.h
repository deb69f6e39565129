#pragma once

#include <Eigen/Core>

namespace eod::sim {

/// How the light of a lamp fades with the distance: the words of SDFormat's <attenuation>.
struct Falloff {
  double range = 10;     ///< [m] nothing arrives beyond it
  double constant = 1;   ///< of 1 / (constant + linear d + quadratic d^2), ...
  double linear = 0;     ///< [1/m] ...
  double quadratic = 0;  ///< [1/m^2] ... which (1 - (d / range)^4)^2 brings to zero at the range
                         ///< (B. Karis, "Real Shading in Unreal Engine 4", 2013)

  /// Share of the lamp's light at `distance` [m].
  double At(double distance) const {
    if (distance >= range) return 0;
    const double d2 = distance * distance;
    const double share = d2 / (range * range);
    const double window = (1 - share * share) * (1 - share * share);
    return window / (constant + linear * distance + quadratic * d2);
  }
};

/// A lamp that shines to all sides, by its brightness: 1 on a white surface that faces it is as
/// white as a picture can be.
struct LampLight {
  Eigen::Vector3f colour = Eigen::Vector3f::Ones();  ///< linear, its intensity counted in
  Falloff falloff;
};

}  // namespace eod::sim
