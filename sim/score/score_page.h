#pragma once

#include <string>

#include "sim/score/score_sheet.h"

namespace eod::sim {

/// The sheet as one self-contained HTML page, to be read and printed: verdict, bars of the parts
/// with their items, check list, events, and a map with the robot's way.
std::string ToPage(const ScoreSheet& sheet);

/// The robot's way on the map, with events and places, as an SVG element; "" without a way.
std::string ToMap(const ScoreSheet& sheet);

/// Text as HTML shows it literally.
std::string EscapeHtml(const std::string& text);

}  // namespace eod::sim
