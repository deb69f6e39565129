#pragma once

#include <filesystem>

#include "lockstep/rig.h"

namespace eod::lockstep {

/// A candump log to be replayed without any other process.
struct ReplayConfig {
  RigConfig rig;
  std::filesystem::path can_log;  ///< in: what was on the bus; the robot's own frames are left out
  std::filesystem::path out;      ///< folder, made if missing
  std::filesystem::path report;   ///< folder for the score, see sim::MissionReport; empty: none
  Duration tail = std::chrono::seconds(1);  ///< virtual time after the last frame
};

/// Plays the box's frames of a log to bridge and simulator in lock-step; the same log gives the
/// same bytes. Time runs on the log's time stamps, rounded up to a tick.
///
/// Writes states.csv (StateCsv), can.log (what the robot sent) and result.json into `out`; each
/// appears only when it is complete. Throws std::runtime_error with one line for a log that cannot
/// be read, is not in the order of time or has no frame of the box, and for an `out` that cannot be
/// written.
void ReplayLog(const ReplayConfig& config, const sim::RobotModel& robot,
               const sim::WorldModel& world, const sim::Scenario& scenario);

}  // namespace eod::lockstep
