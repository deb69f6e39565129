#pragma once

#include <cstdint>
#include <span>

#include <Eigen/Core>

namespace eod::sim {

/// One camera-facing square of a plume, in the module's frame.
struct PlumeQuad {
  Eigen::Vector3f p_M = Eigen::Vector3f::Zero();     ///< centre [m]
  float half_size = 0;                               ///< [m]
  Eigen::Vector3f colour = Eigen::Vector3f::Zero();  ///< linear, brightness counted in
  float alpha = 0;                                   ///< 0..1
  float angle = 0;                                   ///< [rad] in the picture's plane
  bool additive = false;                             ///< flame; otherwise smoke
};

/// What an explosion does to the pictures beside its plume.
struct PictureEffects {
  float flash = 0;    ///< 0..1 towards white
  float shake = 0;    ///< [rad] amplitude of the camera's shaking
  float noise = 0;    ///< 0..1 of the picture replaced by noise; 1: the feed is dead
  uint32_t seed = 0;  ///< of shake and noise, another one each step
  bool operator==(const PictureEffects&) const = default;
};

}  // namespace eod::sim
