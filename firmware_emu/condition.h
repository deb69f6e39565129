#pragma once

#include <cstdint>
#include <string>

#include "firmware_emu/odometer.h"
#include "firmware_emu/panel_status.h"
#include "firmware_emu/word_reader.h"

namespace eod::box {

/// Something an operator can see on the box, such as "lamp collision on" or "heading >= 88".
struct Condition {
  enum class Subject : uint8_t {
    kLamp,
    kLit,
    kBuzzer,
    kAlarm,
    kInhibit,
    kBoxState,
    kRobotState,
    kMission,
    kModule,
    kLink,
    kHeading,
    kPitch,
    kRoll,
    kSpeed,
    kJoint,
    kScore,
    kStep,
    kCollisions,
    kBattery,
    kTravel,
    kTurned,
    kGrasp,
    kBomb,
    kFire,
    kReason,
    kFailure
  };
  enum class Comparison : uint8_t { kGreaterEqual, kLessEqual, kGreater, kLess };

  Subject subject = Subject::kLink;
  bool is_negated = false;
  int index = 0;         ///< lamp, joint or motion
  int choice = 0;        ///< wanted pattern, state, code
  uint32_t motions = 0;  ///< kInhibit: bit m-1; 0 = none
  Comparison comparison = Comparison::kGreaterEqual;
  double number = 0;
};

/// Reads a condition from the front of `words`. Throws std::runtime_error with the word and what is
/// allowed.
Condition ParseCondition(WordReader& words);

bool Holds(const Condition& condition, const PanelStatus& status, const Odometer& odometer);

/// What the box shows in place of the condition, for messages: "lamp collision is off".
std::string Observed(const Condition& condition, const PanelStatus& status,
                     const Odometer& odometer);

}  // namespace eod::box
