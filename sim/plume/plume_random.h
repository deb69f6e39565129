#pragma once

#include <cstdint>

namespace eod::sim {

/// Repeatable stream of pseudo-random numbers; every standard library gives the same. An avalanche
/// of two multiplications over a counter (constants by C. Wellons, "lowbias32").
class PlumeRandom {
 public:
  explicit PlumeRandom(uint32_t seed = 0) : state_(seed) {}

  uint32_t Next() {
    state_ += 0x9e3779b9U;
    uint32_t value = state_;
    value = (value ^ (value >> 16)) * 0x7feb352dU;
    value = (value ^ (value >> 15)) * 0x846ca68bU;
    return value ^ (value >> 16);
  }
  /// Uniform in [low, high).
  double Uniform(double low, double high) { return low + (high - low) * (Next() * 0x1p-32); }

 private:
  uint32_t state_;
};

}  // namespace eod::sim
