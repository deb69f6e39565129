#pragma once

#include <string>
#include <vector>

#include "firmware_emu/panel_status.h"
#include "platform/time.h"

namespace eod::box {

/// Tells what changed on the box, a line a change, for logs and for people who watch a script.
class PanelJournal {
 public:
  /// Lines for what changed since the last call.
  std::vector<std::string> Observe(const PanelStatus& status);

 private:
  void ObserveMission(const dbc::RobotFeedback& robot, std::vector<std::string>& lines) const;

  PanelStatus last_;
};

/// "collision fast, link on": lamps that are not off; "none" if all are.
std::string LampsText(const PanelStatus& status);

/// "M01 M05-M08" for the motions of `mask`, three or more in a row joined; "none" for an empty one.
std::string MotionsText(uint32_t mask);

/// "front left wheel, crossbeam" for the parts of `mask`; "none" for an empty one.
std::string PartsText(uint32_t mask);

}  // namespace eod::box
