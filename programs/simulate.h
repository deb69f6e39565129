#pragma once

#include "programs/sim_options.h"

namespace eod::sim {

/// Runs the simulator on real time and LCM, with its cameras, until an end signal. Prints steps,
/// overruns and pictures at the end. Throws what loading and opening throw.
void SimulateLive(const SimOptions& options, const StationOptions& station);

/// Replays `options.can_log` in lock-step into `options.out`, without any other program.
void SimulateLog(const SimOptions& options);

}  // namespace eod::sim
