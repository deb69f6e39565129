#pragma once

#include <cstdint>
#include <string>

#include "firmware_emu/odometer.h"
#include "firmware_emu/panel_status.h"
#include "firmware_emu/sight.h"
#include "firmware_emu/word_reader.h"

namespace eod::box {

/// Something an operator can see on the box, such as "lamp collision on" or "heading >= 88", or of
/// the robot itself, such as "distance can < 2".
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
    kFailure,
    // From here on by eye.
    kX,
    kY,
    kZ,
    kDistance,
    kAhead,
    kSide,
    kHeight,
    kTilt,
    kSeen
  };
  enum class Comparison : uint8_t { kGreaterEqual, kLessEqual, kGreater, kLess };

  Subject subject = Subject::kLink;
  bool is_negated = false;
  int index = 0;         ///< lamp, joint or motion
  std::string object;    ///< kDistance and after it
  int choice = 0;        ///< wanted pattern, state, code
  uint32_t motions = 0;  ///< kInhibit: bit m-1; 0 = none
  Comparison comparison = Comparison::kGreaterEqual;
  double number = 0;
};

/// Reads a condition from the front of `words`. Throws std::runtime_error with the word and what is
/// allowed.
Condition ParseCondition(WordReader& words);

/// `sight` is null when nothing is seen: then no condition by eye holds, negated or not.
bool Holds(const Condition& condition, const PanelStatus& status, const Odometer& odometer,
           const Sight* sight = nullptr);

/// What there is in place of the condition, for messages: "lamp collision is off".
std::string Observed(const Condition& condition, const PanelStatus& status,
                     const Odometer& odometer, const Sight* sight = nullptr);

}  // namespace eod::box
