#pragma once

#include <atomic>
#include <optional>

#include "batch/ground.h"
#include "batch/plan.h"
#include "batch/run_record.h"

namespace eod::batch {

struct RunLimits {
  Duration longest = std::chrono::seconds(3600);   ///< simulated, whatever the scenario says
  Duration preparing = std::chrono::seconds(120);  ///< beside the scenario's own time limit
  Duration closing = std::chrono::seconds(2);      ///< for the exercise to end behind its script
};

/// What every run of that pair and repetition depends on.
RunInputs InputsOf(const Ground& ground, const PlannedRun& run);

/// Drives one run in lock-step, as fast as the processor allows; the same run gives the same
/// record. It ends when the exercise does, when its script fails, a moment after the script has
/// ended, or when time is up. None if `stop` became true meanwhile. Throws std::runtime_error for a
/// scenario that does not fit the world.
std::optional<RunRecord> DriveRun(const Ground& ground, const PlannedRun& run,
                                  const RunLimits& limits, const std::atomic<bool>& stop);

}  // namespace eod::batch
