#pragma once

#include <ostream>
#include <string>

#include "sim/simulator.h"

namespace eod::sim {

/// Writes what the steps found as text, one line a step: for comparison and for other tools.
///
/// Columns: step, time_us (since 1970, or since the start of a lock-step run), module, x_m, y_m,
/// z_m (module's local frame), heading_rad, pitch_rad, roll_rad, j1 .. j9 (rad, J7 in m), left_m,
/// right_m (openings), speed_mps, turn_rps, inhibited and contact_parts (hexadecimal sets), reason,
/// alarms (hexadecimal codes, gravest first, joined by '+'), mission, mission_step, score. Every
/// number is the shortest text that reads back as the same bits, so equal runs give equal bytes.
class StateCsv {
 public:
  /// Writes the heading. `out` must outlive this.
  explicit StateCsv(std::ostream& out);

  void Write(const StepResult& result, const AlarmTable& alarms);

 private:
  std::ostream& out_;
  std::string line_;
};

}  // namespace eod::sim
