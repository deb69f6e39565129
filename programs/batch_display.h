#pragma once

#include "batch/batch_run.h"

namespace eod::batch {

/// Runs `run` on `jobs` threads until all is done, and tells how it goes: a bar on a terminal,
/// lines elsewhere. Throws what a run threw, and std::runtime_error that says how to go on when an
/// end signal interrupts it.
void Display(BatchRun& run, int jobs);

}  // namespace eod::batch
