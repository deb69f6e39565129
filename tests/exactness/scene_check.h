#pragma once

#include <cstdint>

#include "tests/exactness/judge.h"

namespace eod::sim {

/// Casts `count` tricky segments in a tricky scene, on every instruction set that this processor
/// has, and judges each answer.
Verdict CheckScene(uint64_t seed, size_t count);

}  // namespace eod::sim
