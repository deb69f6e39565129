#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "firmware_emu/word_reader.h"
#include "platform/time.h"

namespace eod::box {

/// Somewhere to go by eye. Points are in the module's local frame [m].
struct Manoeuvre {
  enum class Kind : uint8_t {
    kDriveTo,   ///< the robot's origin to a point or an object
    kTurnTo,    ///< on the spot, to a heading or until an object is dead ahead
    kApproach,  ///< until an object is `ahead` of and `side` to the right of the robot's origin
  };
  static constexpr Duration kUsualLimit = std::chrono::seconds(120);
  static constexpr double kNearest = 0.4;  ///< [m] kApproach: nearer, a heading means nothing

  Kind kind = Kind::kDriveTo;
  std::string object;  ///< what to go by; empty: x, y or heading_deg
  double x = 0, y = 0;
  double heading_deg = 0;
  double ahead = 0, side = 0;
  bool backwards = false;  ///< kDriveTo: rear first
};

bool IsManoeuvreWord(std::string_view verb);

/// Reads what follows the first word `verb`, up to "within". Throws std::runtime_error with the
/// word and what is allowed.
Manoeuvre ParseManoeuvre(std::string_view verb, WordReader& words);

}  // namespace eod::box
