#include "tests/unit/plume/plume_mask.h"

#include <algorithm>
#include <cmath>

namespace eod::sim {

PlumeMask::PlumeMask(std::span<const PlumeQuad> quads, double core) {
  for (const PlumeQuad& quad : quads) {
    const double x = static_cast<double>(quad.p_M.x()) / kCell + kSide / 2.0;
    const double y = static_cast<double>(quad.p_M.z()) / kCell;
    const double radius = core * static_cast<double>(quad.half_size) / kCell;
    const auto first = [&](double centre) {
      return std::max(0, static_cast<int>(std::floor(centre - radius)));
    };
    const auto last = [&](double centre) {
      return std::min(kSide - 1, static_cast<int>(std::floor(centre + radius)));
    };
    for (int row = first(y); row <= last(y); ++row) {
      for (int column = first(x); column <= last(x); ++column) {
        // The cell that holds the centre is covered however small the quad.
        const bool holds = row == static_cast<int>(y) && column == static_cast<int>(x);
        if (holds || std::hypot(column + 0.5 - x, row + 0.5 - y) <= radius) {
          cells_.set(static_cast<size_t>(row * kSide + column));
        }
      }
    }
  }
}

double PlumeMask::Likeness(const PlumeMask& other) const {
  const size_t both = (cells_ & other.cells_).count();
  const size_t either = (cells_ | other.cells_).count();
  return either == 0 ? 1 : static_cast<double>(both) / static_cast<double>(either);
}

}  // namespace eod::sim
