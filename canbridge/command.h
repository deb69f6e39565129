#pragma once

#include "canbridge/bridge_messages.h"
#include "canbridge/link_supervision.h"
#include "dbc/panel_state.h"

namespace eod::bridge {

/// Which of the box's messages are recent enough to be believed.
struct PanelFreshness {
  bool panel = false;  ///< BOX_PANEL: camera, light, menu
  bool fire = false;   ///< BOX_FIRE: not older than 100 ms, and the last one was accepted
};

/// The operator's command after supervision. Without fresh panel frames momentary controls (menu
/// command, zoom, horn, acknowledge, reset) count as released and switches stay as they were. A
/// preset moves the robot and the fire panel fires: both pass only while motion is permitted, the
/// fire panel only while its frames are fresh too; else the arm key counts as safe, the buttons as
/// released, and no circuit is selected.
BoxCommand ComposeCommand(const Supervision& supervision, const dbc::PanelState& panel,
                          const PanelFreshness& fresh);

/// CANopen emergency that ROB_EMCY tells for a stop or fault; 0 = none.
int EmergencyCode(const Supervision& supervision);
/// CANopen error register that goes with it.
int ErrorRegister(int emergency_code);

}  // namespace eod::bridge
