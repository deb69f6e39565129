#pragma once

#include <string>
#include <string_view>

namespace eod::console {

/// The camera that an operator who chose `camera_select` (box_command_t) looks at, and the one
/// beside it: those that the simulator sends at the full rate.
struct Shown {
  std::string_view chosen;
  std::string_view beside;  ///< empty: the quad picture stands alone
};
Shown ShownFor(int camera_select);

/// What the trainee is to do now: `step` is 0-based, of `steps`.
std::string StepText(bool is_running, int step, int steps, std::string_view text);

/// The page: the text "step", the streams "chosen" and "beside" (hidden while
/// the text "beside" is empty), and links to each camera alone.
std::string OperatorPage();

}  // namespace eod::console
