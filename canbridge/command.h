#pragma once

#include "canbridge/bridge_messages.h"
#include "canbridge/link_supervision.h"
#include "dbc/panel_state.h"

namespace eod::bridge {

/// The operator's command after supervision. Without fresh `panel` frames momentary controls (menu
/// command, zoom, horn, acknowledge, reset) count as released and switches stay as they were; a
/// preset moves the robot, so it passes only while motion is permitted. Fire controls never pass.
BoxCommand ComposeCommand(const Supervision& supervision, const dbc::PanelState& panel,
                          bool is_panel_fresh);

/// CANopen emergency that ROB_EMCY tells for a stop or fault; 0 = none.
int EmergencyCode(const Supervision& supervision);
/// CANopen error register that goes with it.
int ErrorRegister(int emergency_code);

}  // namespace eod::bridge
