#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

namespace eod::sim {

// What painters of textures share: colours are gamma 2, coordinates count in tiles.

using Colour = Eigen::Vector3f;

inline Colour Grey(float value) { return Colour::Constant(value); }

inline Colour Mix(const Colour& a, const Colour& b, float share) { return a + (b - a) * share; }

inline float SmoothStep(float low, float high, float value) {
  const float t = std::clamp((value - low) / (high - low), 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

/// Position within a repeating cell: which cell, and where in it (0..1).
struct Cell {
  int index;
  float place;
};

inline Cell CellOf(float coordinate, int cells) {
  const float scaled = coordinate * static_cast<float>(cells);
  const float floor = std::floor(scaled);
  return {static_cast<int>(floor), scaled - floor};
}

/// Distance to the nearer edge of a cell, in shares of the cell.
inline float EdgeDistance(float place) { return std::min(place, 1.0F - place); }

}  // namespace eod::sim
