#pragma once

#include <CLI/App.hpp>

#include "recorder/recorder_config.h"

namespace eod::recorder {

/// Registers all but the station's options. Values go to `config`, which must outlive the parsing.
void AddRecorderOptions(CLI::App& app, RecorderConfig& config);

}  // namespace eod::recorder
