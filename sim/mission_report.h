#pragma once

#include <filesystem>
#include <utility>

#include "sim/simulator.h"

namespace eod::sim {

/// Writes the report of a mission when it ends, or when the run does. A later mission's report
/// takes the place of an earlier one's.
class MissionReport {
 public:
  /// `folder` as WriteReport has it; empty: nothing is written.
  explicit MissionReport(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// After every step. Writes, in the step that ends a mission; throws as WriteReport does.
  void Watch(const Simulator& simulator);
  /// When the run is over: writes if a mission is under way.
  void Finish(const Simulator& simulator);

 private:
  std::filesystem::path folder_;
  bool is_written_ = true;  ///< the mission that runs or ran last
};

}  // namespace eod::sim
