#pragma once

#include <limits>

namespace eod::sim {

/// When a failure that ends an exercise has come. The values of a new one never come.
struct CriticalRules {
  double link_lost = std::numeric_limits<double>::infinity();    ///< [s] without a link
  double bomb_below = -std::numeric_limits<double>::infinity();  ///< [m] z of a charge that is lost
};

}  // namespace eod::sim
