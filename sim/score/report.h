#pragma once

#include <filesystem>

#include "sim/score/score_sheet.h"

namespace eod::sim {

/// Writes score.json and report.html into `folder`, which is made if missing. Each file appears
/// complete or not at all. Throws std::runtime_error with one line that names what cannot be
/// written.
void WriteReport(const ScoreSheet& sheet, const std::filesystem::path& folder);

}  // namespace eod::sim
