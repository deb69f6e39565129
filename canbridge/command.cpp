#include "canbridge/command.h"

namespace eod::bridge {
namespace {

template <typename Enum>
Enum KnownOr(Enum value, Enum otherwise) {
  return value == Enum::kNotAvailable ? otherwise : value;
}

}  // namespace

BoxCommand ComposeCommand(const Supervision& supervision, const dbc::PanelState& panel,
                          const PanelFreshness& fresh) {
  BoxCommand command;
  command.system_state = supervision.state;
  command.motion_permitted = supervision.motion_permitted;
  command.motion_rate = supervision.rate;
  command.inhibit_mask = supervision.inhibit_mask;
  command.inhibit_reason = supervision.reason;
  command.speed_range = KnownOr(panel.speed_range, dbc::SpeedRange::kCreep);
  command.control_mode = KnownOr(panel.mode, dbc::ControlMode::kNone);
  command.preset = supervision.motion_permitted && panel.preset <= 7 ? panel.preset : 0;
  command.menu_module = KnownOr(panel.menu_module, dbc::Module::kNone);
  command.menu_exercise = panel.menu_exercise;
  command.camera_select = KnownOr(panel.camera, dbc::CameraSelect::kDrive);
  command.light = panel.light;
  command.infrared = panel.infrared;
  command.resets = supervision.resets;
  if (fresh.fire && supervision.motion_permitted) {
    command.fire = {.arm_key = panel.arm_key,
                    .fire_left = panel.fire_left,
                    .fire_right = panel.fire_right,
                    .circuit = panel.circuit,
                    .nonce_echo = panel.nonce_echo};
  }
  if (fresh.panel) {
    command.menu_command = panel.menu_command;
    command.camera_zoom = panel.camera_zoom;
    command.horn = panel.horn;
    command.lamp_test = panel.lamp_test;
    command.buzzer_acknowledge = panel.buzzer_acknowledge;
    command.alarm_reset = panel.alarm_reset;
  }
  return command;
}

// Codes of CiA 301: 0x61xx internal software, 0x8100 communication, 0x8130 heartbeat lost, 0x90xx
// external error.
int EmergencyCode(const Supervision& supervision) {
  switch (supervision.refusal) {
    case Refusal::kEstop:
    case Refusal::kRobotEstop:
      return 0x9000;
    case Refusal::kEstopContradiction:
    case Refusal::kBoxFault:
      return 0x9001;
    case Refusal::kCrcFault:
      return 0x8100;
    case Refusal::kLinkLatched:
    case Refusal::kRobotLinkLatched:
    case Refusal::kSafetyLost:
    case Refusal::kMotionLost:
    case Refusal::kAxesLost:
    case Refusal::kHeartbeatLost:
      return 0x8130;
    default:
      return supervision.state == dbc::SystemState::kFault ? 0x6100 : 0;
  }
}

int ErrorRegister(int emergency_code) {
  constexpr int kGeneric = 0x01;
  constexpr int kCommunication = 0x10;
  constexpr int kManufacturer = 0x80;
  if (emergency_code == 0) return 0;
  return kGeneric | ((emergency_code & 0xFF00) == 0x8100 ? kCommunication : kManufacturer);
}

}  // namespace eod::bridge
