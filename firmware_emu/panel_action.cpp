#include "firmware_emu/panel_action.h"

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "firmware_emu/vocabulary.h"

namespace eod::box {
namespace {

enum class Argument : uint8_t { kNone, kChoice, kPercent, kInteger, kMotions, kStick, kMenu };

struct ActionWord {
  std::string_view verb;
  Control control;
  Argument argument;
  std::span<const std::string_view> choices = {};
  int maximum = 0;  ///< kInteger: 0..maximum
};

constexpr std::array kActionWords{
    ActionWord{"press", Control::kPress, Argument::kMotions},
    ActionWord{"release", Control::kRelease, Argument::kMotions},
    ActionWord{"stick", Control::kStick, Argument::kStick, words::kStick},
    ActionWord{"key", Control::kKey, Argument::kChoice, words::kKey},
    ActionWord{"estop", Control::kEstop, Argument::kChoice, words::kReleasePress},
    ActionWord{"estop_a_fault", Control::kEstopAFault, Argument::kChoice, words::kOffOn},
    ActionWord{"deadman", Control::kDeadman, Argument::kChoice, words::kDeadman},
    ActionWord{"reset", Control::kReset, Argument::kNone},
    ActionWord{"start", Control::kStart, Argument::kNone},
    ActionWord{"mode", Control::kMode, Argument::kChoice, words::kMode},
    ActionWord{"speed", Control::kSpeed, Argument::kChoice, words::kSpeed},
    ActionWord{"speed_limit", Control::kSpeedLimit, Argument::kPercent},
    ActionWord{"rate", Control::kRate, Argument::kPercent},
    ActionWord{"select_joint", Control::kSelectJoint, Argument::kInteger, {}, dbc::kJointCount},
    ActionWord{"preset", Control::kPreset, Argument::kChoice, words::kPreset},
    ActionWord{"camera", Control::kCamera, Argument::kChoice, words::kCamera},
    ActionWord{"zoom", Control::kZoom, Argument::kChoice, words::kZoom},
    ActionWord{"focus", Control::kFocus, Argument::kChoice, words::kFocus},
    ActionWord{"light", Control::kLight, Argument::kChoice, words::kLight},
    ActionWord{"infrared", Control::kInfrared, Argument::kChoice, words::kOffOn},
    ActionWord{"horn", Control::kHorn, Argument::kChoice, words::kOffOn},
    ActionWord{"talk", Control::kTalk, Argument::kChoice, words::kOffOn},
    ActionWord{"listen", Control::kListen, Argument::kChoice, words::kOffOn},
    ActionWord{"lamp_test", Control::kLampTest, Argument::kChoice, words::kOffOn},
    ActionWord{"acknowledge", Control::kAcknowledge, Argument::kNone},
    ActionWord{"alarm_reset", Control::kAlarmReset, Argument::kNone},
    ActionWord{"menu", Control::kMenu, Argument::kMenu},
    ActionWord{"brightness", Control::kBrightness, Argument::kPercent},
    ActionWord{"arm_key", Control::kArmKey, Argument::kChoice, words::kArmKey},
    ActionWord{"fire_left", Control::kFireLeft, Argument::kChoice, words::kFireButton},
    ActionWord{"fire_right", Control::kFireRight, Argument::kChoice, words::kFireButton},
    ActionWord{"circuit", Control::kCircuit, Argument::kInteger, {}, 3},
    ActionWord{"power", Control::kPower, Argument::kChoice, words::kOffOn},
};

// "menu module flat" and "menu exercise 3" choose, "menu start" presses a menu key.
PanelAction ParseMenu(WordReader& reader) {
  if (reader.TakeIf("module")) {
    return {.control = Control::kModule, .choice = reader.TakeChoice(words::kModule)};
  }
  if (reader.TakeIf("exercise")) {
    return {.control = Control::kExercise, .choice = reader.TakeInteger(0, kExercises)};
  }
  if (reader.at_end()) {
    throw std::runtime_error(
        fmt::format("'menu': allowed after it: module, exercise, {}", JoinWords(words::kMenu)));
  }
  return {.control = Control::kMenu, .choice = reader.TakeChoice(words::kMenu)};
}

PanelAction ParseArguments(const ActionWord& word, WordReader& reader) {
  PanelAction action{.control = word.control};
  switch (word.argument) {
    case Argument::kNone:
      break;
    case Argument::kChoice:
      action.choice = reader.TakeChoice(word.choices);
      break;
    case Argument::kPercent:
      action.share = reader.TakePercent(0, 100);
      break;
    case Argument::kInteger:
      action.choice = reader.TakeInteger(0, word.maximum);
      break;
    case Argument::kStick:
      action.choice = reader.TakeChoice(word.choices);
      action.share = reader.TakePercent(-100, 100);
      break;
    case Argument::kMotions:
      if (word.control == Control::kRelease && reader.TakeIf("all")) {
        action.control = Control::kReleaseAll;
      } else {
        action.motions = reader.TakeMotions();
      }
      break;
    case Argument::kMenu:
      return ParseMenu(reader);
  }
  return action;
}

}  // namespace

bool PanelAction::is_tap() const {
  return control == Control::kReset || control == Control::kStart || control == Control::kMenu ||
         control == Control::kAcknowledge || control == Control::kAlarmReset;
}

PanelAction ParseAction(std::string_view verb, WordReader& words) {
  for (const ActionWord& word : kActionWords) {
    if (word.verb == verb) return ParseArguments(word, words);
  }
  throw std::runtime_error(fmt::format("'{}': allowed: {}", verb, ActionWords()));
}

PanelAction ParseAction(std::string_view line) {
  WordReader words(line);
  const std::string verb = words.Take(ActionWords());
  const PanelAction action = ParseAction(verb, words);
  words.RequireEnd();
  return action;
}

bool IsActionWord(std::string_view verb) {
  const auto has_verb = [verb](const ActionWord& word) { return word.verb == verb; };
  return std::any_of(kActionWords.begin(), kActionWords.end(), has_verb);
}

std::string ActionWords() {
  std::array<std::string_view, kActionWords.size()> verbs;
  for (size_t i = 0; i < verbs.size(); ++i) verbs[i] = kActionWords[i].verb;
  return JoinWords(verbs);
}

}  // namespace eod::box
