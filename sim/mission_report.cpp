#include "sim/mission_report.h"

#include "sim/score/report.h"

namespace eod::sim {

void MissionReport::Watch(const Simulator& simulator) {
  const Scorer& scorer = simulator.scorer();
  if (folder_.empty() || !scorer.has_started()) return;
  if (!scorer.is_over()) {
    is_written_ = false;
  } else if (!is_written_) {
    Finish(simulator);
  }
}

void MissionReport::Finish(const Simulator& simulator) {
  if (folder_.empty() || is_written_ || !simulator.scorer().has_started()) return;
  is_written_ = true;
  WriteReport(simulator.scorer().Sheet(), folder_);
}

}  // namespace eod::sim
