#pragma once

#include <span>
#include <vector>

#include "sim/faults/active_faults.h"
#include "sim/robot/robot_model.h"
#include "sim/scenario/scenario.h"

namespace eod::sim {

/// Where an exercise stands, as far as faults wait for it.
struct FaultMoment {
  double dt_s = 0;
  bool running = false;  ///< the mission runs; no fault begins unless it does
  double elapsed_s = 0;  ///< of the mission
  int steps_done = 0;    ///< steps of the mission that are complete
  bool holds_charge = false;
};

/// A fault began or ended.
struct FaultChange {
  int index = 0;  ///< in Scenario::faults
  bool begins = false;
  bool operator==(const FaultChange&) const = default;
};

/// Breaks things when the scenario says so, and mends them after their time. Each fault begins once
/// a mission. Pure; no allocation after construction.
class FaultInjector {
 public:
  /// Throws std::runtime_error "FILE:LINE: …" for a target that the robot or box does not have (it
  /// names the nearest), an amount out of range, a step that the exercise does not have, or a cable
  /// that snags where there is none.
  FaultInjector(const Scenario& scenario, const RobotModel& robot);

  /// The module is entered anew: everything works.
  void Reset();
  /// Once a step, at its beginning.
  void Advance(const FaultMoment& moment);

  const ActiveFaults& active() const { return active_; }
  /// Of the last Advance.
  std::span<const FaultChange> changes() const { return changes_; }
  /// The scenario's, for the log.
  std::span<const FaultSpec> specs() const { return specs_; }

 private:
  enum class Stage : uint8_t { kWaiting, kActive, kOver };
  struct Progress {
    Stage stage = Stage::kWaiting;
    double age_s = 0;
  };
  bool IsDue(const FaultSpec& spec, const FaultMoment& moment) const;
  void Collect();

  std::vector<FaultSpec> specs_;
  std::vector<int> targets_;  ///< index of each one's target among its kind; -1 without
  std::vector<Progress> progress_;
  std::vector<FaultChange> changes_;
  ActiveFaults active_;
};

}  // namespace eod::sim
