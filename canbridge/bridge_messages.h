#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "dbc/panel_state.h"
#include "dbc/robot_feedback.h"
#include "platform/can_bus.h"
#include "platform/time.h"

namespace eod::bridge {

/// The fire panel as the box reports it; the values of a new one are the safe ones.
struct FirePanel {
  dbc::FireContact arm_key = dbc::FireContact::kOff;
  dbc::FireContact fire_left = dbc::FireContact::kOff;
  dbc::FireContact fire_right = dbc::FireContact::kOff;
  int circuit = 0;     ///< 0 none, 1..3
  int nonce_echo = 0;  ///< 0..255

  bool operator==(const FirePanel&) const = default;
};

/// What the operator asks of the robot: box_command_t in the bridge's own terms. Two equal commands
/// need not be published twice.
struct BoxCommand {
  dbc::SystemState system_state = dbc::SystemState::kInit;
  bool motion_permitted = false;
  std::array<double, dbc::kMotionCount> motion_rate{};  ///< 0..1 of the rated speed, M01 first
  uint32_t inhibit_mask = 0;  ///< bit m-1: motion m is wanted, but refused
  dbc::InhibitReason inhibit_reason = dbc::InhibitReason::kNone;
  dbc::SpeedRange speed_range = dbc::SpeedRange::kCreep;
  dbc::ControlMode control_mode = dbc::ControlMode::kNone;
  int preset = 0;
  FirePanel fire;  ///< for the simulator alone: it goes to no CAN bus
  dbc::Module menu_module = dbc::Module::kNone;
  int menu_exercise = 0;
  dbc::MenuCommand menu_command = dbc::MenuCommand::kNone;
  dbc::CameraSelect camera_select = dbc::CameraSelect::kDrive;
  int camera_zoom = 0;
  int light = 0;
  bool infrared = false;
  bool horn = false;
  bool lamp_test = false;
  bool buzzer_acknowledge = false;
  bool alarm_reset = false;
  int resets = 0;  ///< that were accepted since the start

  bool operator==(const BoxCommand&) const = default;
};

/// Where the robot is: what the box shows of robot_state_t, in its units.
struct RobotReport {
  int module = 0;
  double heading_deg = 0;
  double pitch_deg = 0;
  double roll_deg = 0;
  double speed_mps = 0;
  std::array<double, dbc::kJointCount> joint{};  ///< [deg], J7 opening per hand [m]
  uint32_t limit_flags = 0;
  uint32_t inhibit_mask = 0;
  dbc::InhibitReason inhibit_reason = dbc::InhibitReason::kNone;
  int grasp_state = 0;
  int fire_state = 0;
  int fire_nonce = 0;               ///< 0..255
  uint32_t circuit_continuity = 0;  ///< bit c-1: circuit c has its cartridge
  double battery_v = 0;
  double battery_soc = 0;
  double link_quality = 1;    ///< 0..1 of the way between operator and robot
  bool link_latched = false;  ///< the robot heard no command for too long
  bool field_estop = false;   ///< its own emergency stop is pressed
  uint32_t dark_lamps = 0;    ///< bit i: lamp i of the box is broken
};

struct ActiveAlarm {
  int code = 0;
  uint32_t parts = 0;  ///< bits as robot_state_t.contact_parts
  bool operator==(const ActiveAlarm&) const = default;
};

/// The simulator's active alarms, gravest first: alarm_t in the bridge's own terms.
struct AlarmReport {
  static constexpr int kCapacity = 32;  ///< there are 14 alarm codes
  std::array<ActiveAlarm, kCapacity> active{};
  int count = 0;

  std::span<const ActiveAlarm> view() const {
    return {active.data(), static_cast<std::size_t>(count)};
  }
};

/// Progress of the exercise: what the box shows of mission_status_t.
struct MissionReport {
  int state = 0;
  double elapsed_s = 0;
  double score = 0;
  int step = 0;
  int steps = 0;
  int bomb_state = 0;
  int fail_reason = 0;
  int collisions = 0;
};

/// How the bus does, as CanBus tells it.
struct BusReport {
  CanBusState state = CanBusState::kUp;
  CanBusCounters counters;
};

/// Frames that were dropped, by cause.
struct RejectCounts {
  int64_t crc = 0;
  int64_t counter = 0;
  int64_t length = 0;
  int64_t unknown_id = 0;
};

/// Health of the link: link_status_t without the bus's name.
struct LinkStatus {
  dbc::SystemState system_state = dbc::SystemState::kInit;
  BusReport bus;
  int box_frame_age_ms = -1;  ///< of the last valid safety frame, -1: never
  double quality = 0;         ///< 0..1 share of valid frames among those due in the last second
  uint64_t lost = 0;          ///< in counter gaps and in the receiver's queue
  RejectCounts rejects;
  bool foreign_robot = false;
  std::string_view fault;  ///< why motion is refused, static text; empty if it is not
};

/// The bridge's own alarms.
inline constexpr int kLinkAlarm = 0x60;
inline constexpr int kBoxFaultAlarm = 0x70;
inline constexpr int kEstopAlarm = 0x80;

/// One of the bridge's alarms was raised or cleared.
struct AlarmChange {
  int code = 0;
  bool raised = false;
  bool operator==(const AlarmChange&) const = default;
};

}  // namespace eod::bridge
