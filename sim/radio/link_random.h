#pragma once

#include <cstdint>

namespace eod::sim {

/// A number in [0, 1) that depends on its arguments alone; every machine gives the same. The n-th
/// message of a direction draws its own, whatever happened to the others. (Output function of
/// SplitMix64, Steele, Lea and Flood 2014.)
constexpr double LinkRandom(uint64_t seed, uint64_t stream, uint64_t index) {
  uint64_t z = seed + 0x9e3779b97f4a7c15U * (index + 1) + 0xd1342543de82ef95U * stream;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  z ^= z >> 31;
  return static_cast<double>(z >> 11) * 0x1p-53;
}

}  // namespace eod::sim
