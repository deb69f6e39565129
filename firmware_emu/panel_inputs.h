#pragma once

#include "dbc/panel_state.h"

namespace eod::box {

/// What hands do to the box: the mechanical position of every control, before contacts bounce and
/// before the firmware looks at them.
struct PanelInputs {
  bool powered = true;         ///< battery connected
  bool estop_pressed = false;  ///< the mushroom; both contacts follow it
  bool estop_a_fault =
      false;  ///< contact A is broken: it reads "pressed" whatever the mushroom does
  /// All other controls. estop_a, estop_b, box_fault, supply_v, nmt, nonce_echo and the two version
  /// fields are the firmware's business and are ignored here.
  dbc::PanelState controls;

  bool operator==(const PanelInputs&) const = default;
};

}  // namespace eod::box
