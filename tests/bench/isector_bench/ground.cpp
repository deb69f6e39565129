#include <cmath>
#include <cstdint>

#include "tests/bench/isector_bench/site.h"

namespace eod::bench {

namespace {

/// Between -1 and 1, at random by lattice point and layer. Source of the mixing: splitmix64.
double LatticeValue(int64_t i, int64_t j, uint64_t layer) {
  uint64_t bits = static_cast<uint64_t>(i) * 0x9E3779B97F4A7C15u +
                  static_cast<uint64_t>(j) * 0xC2B2AE3D27D4EB4Fu + layer * 0x165667B19E3779F9u;
  bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
  bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
  bits ^= bits >> 31;
  return static_cast<double>(bits >> 11) * 0x1p-52 - 1;
}

/// Value noise: random heights on a lattice of `cell` metres, blended by smoothstep.
double Noise(double x, double y, double cell, uint64_t layer) {
  const double column = std::floor(x / cell), row = std::floor(y / cell);
  const double u = x / cell - column, v = y / cell - row;
  const double blend_u = u * u * (3 - 2 * u), blend_v = v * v * (3 - 2 * v);
  const auto i = static_cast<int64_t>(column), j = static_cast<int64_t>(row);
  const double south = LatticeValue(i, j, layer) * (1 - blend_u) +  //
                       LatticeValue(i + 1, j, layer) * blend_u;
  const double north =
      LatticeValue(i, j + 1, layer) * (1 - blend_u) + LatticeValue(i + 1, j + 1, layer) * blend_u;
  return south * (1 - blend_v) + north * blend_v;
}

}  // namespace

double GroundHeight(double x, double y) {
  return 35 + 3 * Noise(x, y, 60, 1) + 0.15 * Noise(x, y, 6, 2) + 0.03 * Noise(x, y, 1.1, 3);
}

}  // namespace eod::bench
