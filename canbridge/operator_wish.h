#pragma once

#include <cstdint>

#include "canbridge/rate_ramp.h"
#include "dbc/control_map.h"
#include "dbc/panel_state.h"

namespace eod::bridge {

/// What buttons and sticks ask for, before any rule of safety but one: opposite motions that are
/// wanted together are both off.
struct OperatorWish {
  MotionRates rate{};              ///< 0..1, zero for motions in conflict
  uint32_t wanted = 0;             ///< bit m-1: motion m is wanted, also at rate zero
  uint32_t conflict = 0;           ///< bit m-1: motion m and its opposite are both wanted
  bool are_sticks_neutral = true;  ///< every stick valid and within its dead zone
  bool is_neutral = true;          ///< sticks neutral, no button and no preset held
};

/// Reads the wish off the panel. A rate that is not a number counts as zero.
OperatorWish ReadWish(const dbc::ControlMap& map, const dbc::PanelState& panel);

}  // namespace eod::bridge
