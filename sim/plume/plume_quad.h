#pragma once

#include <Eigen/Core>

namespace eod::sim {

/// One camera-facing square of a plume, in the module's frame.
struct PlumeQuad {
  Eigen::Vector3f p_M = Eigen::Vector3f::Zero();     ///< centre [m]
  float half_size = 0;                               ///< [m]
  Eigen::Vector3f colour = Eigen::Vector3f::Zero();  ///< linear, brightness counted in
  float alpha = 0;                                   ///< 0..1
  float angle = 0;                                   ///< [rad] in the picture's plane
  float cover = 0;  ///< 0: flame, adds its light; 1: smoke, hides what is behind
};

}  // namespace eod::sim
