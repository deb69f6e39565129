#pragma once

#include <cstdint>

namespace eod::sim {

/// Repeatable pseudo-random value of a lattice point, 0..1.
float LatticeValue(int x, int y, uint32_t seed);

/// Smooth value noise, 0..1, repeating every `period` lattice units in both directions.
float TilingNoise(float x, float y, int period, uint32_t seed);

/// Sum of `octaves` of TilingNoise, each twice as fine and half as strong as the one before; 0..1,
/// repeating every `period` lattice units of the coarsest.
float TilingFbm(float x, float y, int period, int octaves, uint32_t seed);

/// Repeatable stream of pseudo-random numbers for painting.
class PaintRandom {
 public:
  explicit PaintRandom(uint32_t seed) : state_(seed) {}
  /// Uniform in [low, high).
  float Uniform(float low, float high);

 private:
  uint32_t state_;
};

}  // namespace eod::sim
