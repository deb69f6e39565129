#include "firmware_emu/operator_hands.h"

namespace eod::box {

using dbc::Button;

namespace {

// True once: when `end` is reached. Forgets it then.
bool TakeEnded(std::optional<TimePoint>& end, TimePoint now) {
  if (!end || now < *end) return false;
  end.reset();
  return true;
}

// Holds a control until `end`, but lets go no earlier than what holds it already.
template <typename Position>
void HoldUntil(Position& control, Position held, std::optional<TimePoint>& control_end,
               TimePoint end) {
  const bool is_held_longer = control == held && (!control_end || *control_end >= end);
  if (is_held_longer) return;
  control = held;
  control_end = end;
}

}  // namespace

void OperatorHands::Apply(const PanelAction& action, TimePoint now) {
  switch (action.control) {
    case Control::kPress:
    case Control::kRelease:
      for (int m = 0; m < dbc::kMotionCount; ++m) {
        if ((action.motions >> m & 1u) == 0) continue;
        inputs_.controls.motion[m] = action.control == Control::kPress;
        motion_end_[m].reset();
      }
      return;
    case Control::kReleaseAll:
      ReleaseAll();
      return;
    case Control::kStick:
      inputs_.controls.axis[action.choice] = {.value = action.share, .valid = true};
      return;
    default:
      break;
  }
  if (action.is_tap()) {
    ApplyTap(action.control, action.choice, now + kTapTime);
  } else {
    ApplySelector(action);
  }
}

void OperatorHands::ApplyTap(Control control, int choice, TimePoint end) {
  dbc::PanelState& controls = inputs_.controls;
  if (control == Control::kReset) {
    controls.reset = Button::kPressed;
    reset_end_ = end;
  } else if (control == Control::kStart) {
    controls.start = Button::kPressed;
    start_end_ = end;
  } else if (control == Control::kMenu) {
    controls.menu_command = static_cast<dbc::MenuCommand>(choice);
    menu_end_ = end;
  } else if (control == Control::kAcknowledge) {
    controls.buzzer_acknowledge = true;
    acknowledge_end_ = end;
  } else if (control == Control::kAlarmReset) {
    controls.alarm_reset = true;
    alarm_reset_end_ = end;
  }
}

void OperatorHands::ApplySelector(const PanelAction& action) {
  dbc::PanelState& controls = inputs_.controls;
  const int choice = action.choice;
  const bool is_on = choice != 0;
  switch (action.control) {
    case Control::kPower:
      inputs_.powered = is_on;
      break;
    case Control::kEstop:
      inputs_.estop_pressed = is_on;
      break;
    case Control::kEstopAFault:
      inputs_.estop_a_fault = is_on;
      break;
    case Control::kKey:
      controls.key = static_cast<dbc::KeySwitch>(choice);
      break;
    case Control::kDeadman:
      controls.deadman = static_cast<dbc::Deadman>(choice);
      break;
    case Control::kMode:
      controls.mode = static_cast<dbc::ControlMode>(choice);
      break;
    case Control::kSpeed:
      controls.speed_range = static_cast<dbc::SpeedRange>(choice);
      break;
    case Control::kSpeedLimit:
      controls.speed_limit = action.share;
      break;
    case Control::kRate:
      controls.joint_rate = action.share;
      break;
    case Control::kSelectJoint:
      controls.joint_select = choice;
      break;
    case Control::kPreset:
      controls.preset = choice;
      preset_end_.reset();
      break;
    case Control::kCamera:
      controls.camera = static_cast<dbc::CameraSelect>(choice);
      break;
    case Control::kZoom:
      controls.camera_zoom = choice;
      break;
    case Control::kFocus:
      controls.camera_focus = choice;
      break;
    case Control::kLight:
      controls.light = choice;
      break;
    case Control::kInfrared:
      controls.infrared = is_on;
      break;
    case Control::kHorn:
      controls.horn = is_on;
      break;
    case Control::kTalk:
      controls.push_to_talk = is_on;
      break;
    case Control::kListen:
      controls.listen = is_on;
      break;
    case Control::kLampTest:
      controls.lamp_test = is_on;
      break;
    case Control::kExercise:
      controls.menu_exercise = choice;
      break;
    case Control::kModule:
      controls.menu_module = static_cast<dbc::Module>(choice);
      break;
    case Control::kBrightness:
      controls.brightness = action.share;
      break;
    case Control::kArmKey:
      controls.arm_key = static_cast<dbc::FireContact>(choice);
      break;
    case Control::kFireLeft:
      controls.fire_left = static_cast<dbc::FireContact>(choice);
      fire_left_end_.reset();
      break;
    case Control::kFireRight:
      controls.fire_right = static_cast<dbc::FireContact>(choice);
      fire_right_end_.reset();
      break;
    case Control::kCircuit:
      controls.circuit = choice;
      break;
    default:
      break;
  }
}

void OperatorHands::ReleaseAll() {
  inputs_.controls.motion.fill(false);
  motion_end_.fill(std::nullopt);
  inputs_.controls.axis.fill({});
  inputs_.controls.preset = 0;
  preset_end_.reset();
}

void OperatorHands::HoldMotionUntil(int motion, TimePoint end) {
  const int m = motion - 1;
  HoldUntil(inputs_.controls.motion[m], true, motion_end_[m], end);
}

void OperatorHands::HoldPresetUntil(int preset, TimePoint end) {
  HoldUntil(inputs_.controls.preset, preset, preset_end_, end);
}

void OperatorHands::HoldFireUntil(Control button, TimePoint end) {
  const bool is_left = button == Control::kFireLeft;
  HoldUntil(is_left ? inputs_.controls.fire_left : inputs_.controls.fire_right,
            dbc::FireContact::kOn, is_left ? fire_left_end_ : fire_right_end_, end);
}

void OperatorHands::SetLampTestUntil(TimePoint end) {
  inputs_.controls.lamp_test = true;
  lamp_test_end_ = end;
}

void OperatorHands::Tick(TimePoint now) {
  dbc::PanelState& controls = inputs_.controls;
  if (TakeEnded(reset_end_, now)) controls.reset = Button::kReleased;
  if (TakeEnded(start_end_, now)) controls.start = Button::kReleased;
  if (TakeEnded(menu_end_, now)) controls.menu_command = dbc::MenuCommand::kNone;
  if (TakeEnded(acknowledge_end_, now)) controls.buzzer_acknowledge = false;
  if (TakeEnded(alarm_reset_end_, now)) controls.alarm_reset = false;
  if (TakeEnded(lamp_test_end_, now)) controls.lamp_test = false;
  if (TakeEnded(preset_end_, now)) controls.preset = 0;
  if (TakeEnded(fire_left_end_, now)) controls.fire_left = dbc::FireContact::kOff;
  if (TakeEnded(fire_right_end_, now)) controls.fire_right = dbc::FireContact::kOff;
  for (int m = 0; m < dbc::kMotionCount; ++m) {
    if (TakeEnded(motion_end_[m], now)) controls.motion[m] = false;
  }
}

}  // namespace eod::box
