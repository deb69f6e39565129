#pragma once

#include <array>
#include <cstdint>

namespace eod::dbc {

inline constexpr int kMotionCount = 22;
inline constexpr int kJointCount = 9;
inline constexpr int kAxisCount = 4;
inline constexpr int kLampCount = 14;

enum class KeySwitch : uint8_t { kOff, kStandby, kOperate, kMaintenance, kNotAvailable };
enum class Deadman : uint8_t { kReleased, kEnabled, kPanic, kNotAvailable };
/// Two-bit button as J1939 has it: both bits alike mean a fault of the channel.
enum class Button : uint8_t { kReleased, kPressed, kError, kNotAvailable };
enum class ControlMode : uint8_t {
  kNone,
  kDrive,
  kFlipper,
  kArm,
  kGripper,
  kCamera,
  kPreset,
  kNotAvailable
};
enum class SpeedRange : uint8_t { kCreep, kLow, kHigh, kNotAvailable };
/// Antivalent two-bit contact of the fire circuit.
enum class FireContact : uint8_t { kFault, kOff, kOn };
/// CANopen heartbeat state.
enum class NmtState : uint8_t { kBootUp, kStopped, kOperational, kPreOperational, kUnknown };
enum class CameraSelect : uint8_t { kQuad, kDrive, kGripper, kMast, kRear, kNotAvailable };
enum class Module : uint8_t { kNone, kFlat, kSlope, kBomb, kOutdoor, kIndoor, kNotAvailable };
enum class MenuCommand : uint8_t { kNone, kStart, kPause, kResume, kReset, kEnd };

/// Axis deflection; `valid` is false for the DBC's Error and SNA codes.
struct Axis {
  double value = 0;  ///< -1..1, after the map's inversion, before its dead zone
  bool valid = true;
  bool operator==(const Axis&) const = default;
};

/// Everything a control box says, in the box's own terms (box to robot). Which bits carry it is the
/// business of the DBC and the map.
struct PanelState {
  // BOX_SAFETY
  KeySwitch key = KeySwitch::kOff;
  bool estop_a = true;   ///< channel A: true = healthy
  bool estop_b = false;  ///< channel B: true = pressed (antivalent)
  Deadman deadman = Deadman::kReleased;
  Button reset = Button::kReleased;
  Button start = Button::kReleased;
  ControlMode mode = ControlMode::kDrive;
  SpeedRange speed_range = SpeedRange::kLow;
  double speed_limit = 1;  ///< 0..1
  int box_fault = 0;       ///< 0..255, 0 = none
  double supply_v = 24;    ///< [V]
  int variant = 0;
  int protocol_major = 1;
  // BOX_MOTION
  std::array<bool, kMotionCount> motion{};  ///< button of M01..M22 held
  bool button_channel_fault = false;
  int joint_select = 0;   ///< 0 none, 1..9
  int preset = 0;         ///< 0 none, 1..7
  double joint_rate = 1;  ///< 0..1
  // BOX_AXES, in the order of the map: drive Y, drive X, arm Y, arm X
  std::array<Axis, kAxisCount> axis{};
  // BOX_PANEL
  CameraSelect camera = CameraSelect::kDrive;
  int camera_zoom = 0;   ///< 0 hold, 1 in, 2 out
  int camera_focus = 0;  ///< 0 auto, 1 near, 2 far
  int light = 0;         ///< 0 off, 1 drive, 2 gripper, 3 both
  bool infrared = false;
  bool push_to_talk = false;
  bool listen = false;
  bool lamp_test = false;
  bool horn = false;
  bool buzzer_acknowledge = false;
  bool alarm_reset = false;
  Module menu_module = Module::kNone;
  MenuCommand menu_command = MenuCommand::kNone;
  int menu_exercise = 0;  ///< 0 the one that is loaded, 1..15 which of the module
  double brightness = 1;  ///< 0..1
  // BOX_FIRE
  FireContact arm_key = FireContact::kOff;
  FireContact fire_left = FireContact::kOff;
  FireContact fire_right = FireContact::kOff;
  int circuit = 0;     ///< 0 none, 1..3
  int nonce_echo = 0;  ///< 0..255
  // BOX_HEARTBEAT
  NmtState nmt = NmtState::kPreOperational;
  // BOX_EMCY
  int error_code = 0;      ///< CANopen emergency error code, 0..0xFFFF; 0 = error reset
  int error_register = 0;  ///< CANopen error register: bit 0 generic, 7 manufacturer

  bool operator==(const PanelState&) const = default;
};

}  // namespace eod::dbc
