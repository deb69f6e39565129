#include "firmware_emu/keyboard.h"

#include <algorithm>
#include <array>
#include <optional>

namespace eod::box {
namespace {

using Kind = Key::Kind;

constexpr Duration kLampTestTime = std::chrono::milliseconds(1500);
constexpr double kLimitStep = 0.1;

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

PanelAction SpeedLimitAction(double limit) {
  return {.control = Control::kSpeedLimit, .share = std::clamp(limit, kLimitStep, 1.0)};
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
      return SpeedLimitAction(controls.speed_limit - kLimitStep);
    case '.':
      return SpeedLimitAction(controls.speed_limit + kLimitStep);
    case 'c':
      return PanelAction{.control = Control::kCamera, .choice = NextCamera(controls.camera)};
    case 'b':
      return PanelAction{.control = Control::kAcknowledge};
    case '8':
      return PanelAction{.control = Control::kModule, .choice = 1};
    case '9':
      return PanelAction{.control = Control::kMenu, .choice = 1};
    case '0':
      return PanelAction{.control = Control::kMenu, .choice = 4};
    default:
      return std::nullopt;
  }
}

}  // namespace

KeyOutcome PressKey(const Key& key, TimePoint now, OperatorHands& hands) {
  if (const std::optional<int> motion = MotionOf(key)) {
    hands.HoldMotionUntil(*motion, now + kKeyHoldTime);
    return KeyOutcome::kDone;
  }
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
