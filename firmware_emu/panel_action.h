#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "firmware_emu/word_reader.h"

namespace eod::box {

/// The controls that a script or a panel command can set.
enum class Control : uint8_t {
  kPress,
  kRelease,
  kReleaseAll,
  kStick,
  kKey,
  kEstop,
  kEstopAFault,
  kDeadman,
  kReset,
  kStart,
  kMode,
  kSpeed,
  kSpeedLimit,
  kRate,
  kSelectJoint,
  kPreset,
  kCamera,
  kZoom,
  kFocus,
  kLight,
  kInfrared,
  kHorn,
  kTalk,
  kListen,
  kLampTest,
  kAcknowledge,
  kAlarmReset,
  kModule,
  kExercise,
  kMenu,
  kBrightness,
  kArmKey,
  kFireLeft,
  kFireRight,
  kCircuit,
  kPower
};

/// Exercises of a module that the menu tells apart; 0 leaves it to the simulator.
inline constexpr int kExercises = 15;

/// One thing a hand does to the box.
struct PanelAction {
  Control control = Control::kReleaseAll;
  uint32_t motions = 0;  ///< kPress, kRelease: bit m-1 is motion m
  int choice = 0;        ///< position of a selector, number of a joint, index of a stick
  double share = 0;      ///< kStick -1..1; kSpeedLimit, kRate, kBrightness 0..1

  /// A push button that is pressed for a moment and let go by itself.
  bool is_tap() const;
};

/// Reads one action; its first word was taken already and is `verb`. Throws std::runtime_error with
/// the word and what is allowed.
PanelAction ParseAction(std::string_view verb, WordReader& words);

/// Reads a whole line that must be one action.
PanelAction ParseAction(std::string_view line);

bool IsActionWord(std::string_view verb);

/// All words that begin an action, for messages.
std::string ActionWords();

}  // namespace eod::box
