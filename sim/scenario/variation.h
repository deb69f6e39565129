#pragma once

#include <cstdint>

#include "sim/scenario/scenario.h"

namespace eod::sim {

/// The scenario of a repetition: robot and things are moved evenly within their spreads, one of the
/// lights is picked, and the seed is another one; nothing is left to chance then (spreads are zero,
/// no lights). Pure, from seed and repetition alone, to the same bits everywhere. Repetition 0 is
/// what the file says, with the first of its lights.
Scenario Vary(const Scenario& scenario, uint64_t repetition);

}  // namespace eod::sim
