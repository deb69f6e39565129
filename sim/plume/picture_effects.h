#pragma once

#include <cstdint>

namespace eod::sim {

/// What an explosion does to the pictures beside its plume.
struct PictureEffects {
  float flash = 0;    ///< 0..1 towards white
  float shake = 0;    ///< [rad] amplitude of the camera's shaking
  float noise = 0;    ///< 0..1 of the picture replaced by noise; 1: the feed is dead
  uint32_t seed = 0;  ///< of shake and noise, another one each step
  bool operator==(const PictureEffects&) const = default;
};

}  // namespace eod::sim
