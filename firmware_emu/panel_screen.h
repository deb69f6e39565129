#pragma once

#include <string>

#include "firmware_emu/operator_hands.h"
#include "firmware_emu/panel_status.h"

namespace eod::box {

inline constexpr int kScreenWidth = 80;
inline constexpr int kScreenHeight = 24;

/// The panel as text with ANSI colours for a terminal of 80 x 24: at most 24 lines of at most 80
/// visible characters, drawn over the last picture without clearing it.
std::string DrawPanel(const PanelStatus& status, const PanelInputs& inputs);

}  // namespace eod::box
