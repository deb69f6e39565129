#pragma once

#include <bitset>
#include <span>

#include "sim/plume/plume_quad.h"

namespace eod::sim {

/// What a plume covers, seen from the south without perspective: cells of 0.05 m over 20 x 20 m,
/// the origin in the middle of the lower edge.
class PlumeMask {
 public:
  static constexpr double kCell = 0.05;  // [m]
  static constexpr int kSide = 400;

  /// Each quad covers a disc of `core` of its half size: beyond it the texture is too thin to see.
  PlumeMask(std::span<const PlumeQuad> quads, double core);

  size_t area() const { return cells_.count(); }
  /// Intersection over union.
  double Likeness(const PlumeMask& other) const;

 private:
  std::bitset<kSide * kSide> cells_;
};

}  // namespace eod::sim
