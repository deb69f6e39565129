#include "firmware_emu/keyboard.h"

#include <algorithm>
#include <array>
#include <optional>

namespace eod::box {
namespace {

using Kind = Key::Kind;

constexpr Duration kLampTestTime = std::chrono::milliseconds(1500);
constexpr double kShareStep = 0.1;

constexpr Key Character(char character) {
  return {.kind = Kind::kCharacter, .character = character};
}

// Two rows of keys: the upper one raises, opens, turns counter-clockwise; the lower one undoes it.
constexpr std::array kMotionKeys{
    MotionKey{{.kind = Kind::kUp}, 1},   MotionKey{{.kind = Kind::kDown}, 2},
    MotionKey{{.kind = Kind::kLeft}, 3}, MotionKey{{.kind = Kind::kRight}, 4},
    MotionKey{Character('y'), 5},        MotionKey{Character('h'), 6},
    MotionKey{Character('u'), 7},        MotionKey{Character('j'), 8},
    MotionKey{Character('q'), 9},        MotionKey{Character('a'), 10},
    MotionKey{Character('w'), 11},       MotionKey{Character('s'), 12},
    MotionKey{Character('e'), 13},       MotionKey{Character('d'), 14},
    MotionKey{Character('r'), 15},       MotionKey{Character('f'), 16},
    MotionKey{Character('t'), 17},       MotionKey{Character('g'), 18},
    MotionKey{Character('o'), 19},       MotionKey{Character('p'), 20},
    MotionKey{Character('i'), 21},       MotionKey{Character('k'), 22},
};

// Capitals: what moves several joints at once, or fires, takes two fingers.
struct PresetKey {
  char character;
  int preset;
};
constexpr std::array kPresetKeys{PresetKey{'S', 1}, PresetKey{'T', 2}, PresetKey{'G', 3},
                                 PresetKey{'C', 4}, PresetKey{'D', 5}, PresetKey{'U', 6},
                                 PresetKey{'J', 7}};

std::optional<int> MotionOf(const Key& key) {
  const auto* found = std::find_if(kMotionKeys.begin(), kMotionKeys.end(),
                                   [&key](const MotionKey& entry) { return entry.key == key; });
  if (found == kMotionKeys.end()) return std::nullopt;
  return found->motion;
}

int NextKeyPosition(dbc::KeySwitch key) {
  return key == dbc::KeySwitch::kOperate ? 0 : static_cast<int>(key) + 1;
}

int NextCamera(dbc::CameraSelect camera) { return (static_cast<int>(camera) + 1) % 5; }

// Flat to indoor and round again; "none" is where it begins.
int NextModule(dbc::Module module) { return static_cast<int>(module) % 5 + 1; }

int OtherArmKey(dbc::FireContact key) {
  return static_cast<int>(key == dbc::FireContact::kOn ? dbc::FireContact::kOff
                                                       : dbc::FireContact::kOn);
}

PanelAction DialAction(Control dial, double share) {
  return {.control = dial, .share = std::clamp(share, kShareStep, 1.0)};
}

// Keys of the mission: menu, fire panel, and what is lit.
std::optional<PanelAction> MissionActionOf(char character, const dbc::PanelState& controls) {
  switch (character) {
    case 'A':
      return PanelAction{.control = Control::kArmKey, .choice = OtherArmKey(controls.arm_key)};
    case 'N':
      return PanelAction{.control = Control::kCircuit, .choice = (controls.circuit + 1) % 4};
    case 'l':
      return PanelAction{.control = Control::kLight, .choice = (controls.light + 1) % 4};
    case 'b':
      return PanelAction{.control = Control::kAcknowledge};
    case 'B':
      return PanelAction{.control = Control::kAlarmReset};
    case '6':
      return PanelAction{.control = Control::kMenu, .choice = 2};
    case '7':
      return PanelAction{.control = Control::kMenu, .choice = 3};
    case '8':
      return PanelAction{.control = Control::kModule, .choice = NextModule(controls.menu_module)};
    case 'M':
      return PanelAction{.control = Control::kExercise,
                         .choice = (controls.menu_exercise + 1) % (kExercises + 1)};
    case '9':
      return PanelAction{.control = Control::kMenu, .choice = 1};
    case '0':
      return PanelAction{.control = Control::kMenu, .choice = 4};
    case 'E':
      return PanelAction{.control = Control::kMenu, .choice = 5};
    default:
      return std::nullopt;
  }
}

// Control keys: what they do depends on where the control stands.
std::optional<PanelAction> ActionOf(char character, const PanelInputs& inputs) {
  const dbc::PanelState& controls = inputs.controls;
  const bool is_deadman_held = controls.deadman == dbc::Deadman::kEnabled;
  switch (character) {
    case ' ':
      return PanelAction{.control = Control::kEstop, .choice = 1};
    case 'z':
      return PanelAction{.control = Control::kEstop, .choice = 0};
    case 'x':
      return PanelAction{.control = Control::kDeadman, .choice = is_deadman_held ? 0 : 1};
    case 'm':
      return PanelAction{.control = Control::kKey, .choice = NextKeyPosition(controls.key)};
    case 'n':
      return PanelAction{.control = Control::kReset};
    case '1':
      return PanelAction{.control = Control::kSpeed, .choice = 0};
    case '2':
      return PanelAction{.control = Control::kSpeed, .choice = 1};
    case '3':
      return PanelAction{.control = Control::kSpeed, .choice = 2};
    case ',':
      return DialAction(Control::kSpeedLimit, controls.speed_limit - kShareStep);
    case '.':
      return DialAction(Control::kSpeedLimit, controls.speed_limit + kShareStep);
    case '4':
      return DialAction(Control::kRate, controls.joint_rate - kShareStep);
    case '5':
      return DialAction(Control::kRate, controls.joint_rate + kShareStep);
    case 'c':
      return PanelAction{.control = Control::kCamera, .choice = NextCamera(controls.camera)};
    default:
      return MissionActionOf(character, controls);
  }
}

// Keys that hold something down as long as they repeat.
bool HoldByKey(const Key& key, TimePoint now, OperatorHands& hands, Duration hold) {
  if (const std::optional<int> motion = MotionOf(key)) {
    hands.HoldMotionUntil(*motion, now + hold);
    return true;
  }
  if (key == Character('L') || key == Character('R')) {
    const bool is_left = key == Character('L');
    hands.HoldFireUntil(is_left ? Control::kFireLeft : Control::kFireRight, now + kFireHoldTime);
    return true;
  }
  for (const PresetKey& entry : kPresetKeys) {
    if (key != Character(entry.character)) continue;
    hands.HoldPresetUntil(entry.preset, now + hold);
    return true;
  }
  return false;
}

}  // namespace

KeyOutcome PressKey(const Key& key, TimePoint now, OperatorHands& hands, Duration hold) {
  if (HoldByKey(key, now, hands, hold)) return KeyOutcome::kDone;
  if (key == Character('Q')) return KeyOutcome::kQuit;
  if (key == Character('v')) {
    hands.SetLampTestUntil(now + kLampTestTime);
    return KeyOutcome::kDone;
  }
  std::optional<PanelAction> action;
  if (key.kind == Kind::kEnter) action = PanelAction{.control = Control::kStart};
  if (key.kind == Kind::kCharacter) action = ActionOf(key.character, hands.inputs());
  if (!action) return KeyOutcome::kUnused;
  hands.Apply(*action, now);
  return KeyOutcome::kDone;
}

}  // namespace eod::box
