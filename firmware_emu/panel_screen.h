#pragma once

#include <string>
#include <string_view>

#include "firmware_emu/operator_hands.h"
#include "firmware_emu/panel_status.h"

namespace eod::box {

inline constexpr int kScreenWidth = 80;
inline constexpr int kScreenHeight = 24;

/// The panel as text with ANSI colours for a terminal of 80 x 24: at most 24 lines of at most 80
/// visible characters, drawn over the last picture without clearing it. `alarm` is what the map
/// calls the alarm whose code is shown; it may be empty.
std::string DrawPanel(const PanelStatus& status, const PanelInputs& inputs,
                      std::string_view alarm = {});

}  // namespace eod::box
