#pragma once

#include "canbridge/alarm_board.h"
#include "canbridge/bridge_messages.h"
#include "canbridge/link_supervision.h"
#include "dbc/robot_feedback.h"

namespace eod::bridge {

/// Everything that the box shows comes from these.
struct FeedbackSources {
  const Supervision& supervision;
  const AlarmDisplay& alarms;
  const RobotReport& robot;
  const MissionReport& mission;
  const dbc::PanelState& panel;
  dbc::BuzzerPattern mission_sound = dbc::BuzzerPattern::kOff;  ///< when no alarm sounds
  bool is_link_alive = false;
  bool is_simulator_alive = false;
  bool is_panel_seen = false;     ///< the box sends its camera selection
  bool is_fire_key_seen = false;  ///< the box sends its arm key, and did lately
};

/// What the robot shows on the box, without ages, link quality and heartbeat.
///
/// Lamps by state: power on; link on while box frames come in time; e-stop on while latched;
/// deadman on while the enabling switch is held; grasp slow blink in contact, on when grasped, fast
/// blink when slipping; mission slow blink in the briefing, on when running or won, fast blink when
/// lost; armed on while the arm key is on, slow blink when ready to fire, fast blink for a fault of
/// the fire circuit; fired on after the shot; fault fast blink in state Fault; camera on while a
/// camera is selected. An alarm's pattern overrides the lamp's state. A broken lamp stays
/// dark. Without a simulator there is
/// neither speed nor anything armed.
dbc::RobotFeedback ComposeFeedback(const FeedbackSources& sources);

/// True if a box would show something else in its status display: worth a frame out of turn.
bool DiffersInStatus(const dbc::RobotFeedback& a, const dbc::RobotFeedback& b);
/// True if lamps, buzzer, alarm code or parts differ: worth a frame out of turn.
bool DiffersInAlarm(const dbc::RobotFeedback& a, const dbc::RobotFeedback& b);
/// True if fire state, nonce or continuity differ: worth a frame out of turn.
bool DiffersInFire(const dbc::RobotFeedback& a, const dbc::RobotFeedback& b);

}  // namespace eod::bridge
