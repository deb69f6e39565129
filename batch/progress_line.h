#pragma once

#include <string>

#include "batch/batch_run.h"

namespace eod::batch {

/// "[=====>    ] 12 of 30 runs, 1 not as expected, 213 times real time, 0:35 left" after `elapsed`,
/// cut to `columns`; 0: no bar and no limit.
std::string ProgressLine(const BatchProgress& progress, Duration elapsed, int columns);

}  // namespace eod::batch
