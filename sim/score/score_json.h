#pragma once

#include <string>

#include "sim/score/score_sheet.h"

namespace eod::sim {

/// The sheet as JSON, keys always in the same order, numbers with all their digits: the same sheet
/// gives the same bytes. Without the track, which the page draws.
std::string ToJson(const ScoreSheet& sheet);

}  // namespace eod::sim
