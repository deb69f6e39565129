#pragma once

#include <string>

#include "recorder/run_observer.h"

namespace eod::recorder {

struct LineStyle {
  int columns = 100;   ///< visible width that is never exceeded
  bool colour = true;  ///< ANSI colours
};

/// One line for a terminal: time, lamps as short tags, speed, inhibited motions, camera rate, link,
/// mission step. Details at the end go first when it is narrow. No newline.
std::string FormatStatusLine(const LiveStatus& status, const LineStyle& style);

/// Short name of a lamp, 3 letters.
std::string_view LampTag(dbc::Lamp lamp);
/// Full name, such as "collision".
std::string_view LampName(dbc::Lamp lamp);

/// "M01 M03", "none", or "all".
std::string MotionNames(uint32_t inhibit_mask);

}  // namespace eod::recorder
