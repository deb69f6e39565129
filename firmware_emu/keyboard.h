#pragma once

#include <string_view>

#include "firmware_emu/key_parser.h"
#include "firmware_emu/operator_hands.h"
#include "platform/time.h"

namespace eod::box {

/// Which key does what, for the keyboard and for the screen's legend.
struct MotionKey {
  Key key;
  int motion;  ///< 1..22
};

/// Terminals tell no key-up: a key holds its motion for this long.
inline constexpr Duration kKeyHoldTime = std::chrono::milliseconds(300);

/// Once a key repeats, it is known to be down: then its motion ends this soon after the last
/// repeat.
inline constexpr Duration kRepeatHoldTime = std::chrono::milliseconds(150);

/// A terminal repeats only one key at a time, but firing takes two buttons: each stays down for
/// this long after its key.
inline constexpr Duration kFireHoldTime = std::chrono::seconds(1);

/// What a key asked for beyond the controls of the box.
enum class KeyOutcome : uint8_t { kUnused, kDone, kQuit };

/// Does to `hands` what `key` means; motions and presets are held for `hold`.
KeyOutcome PressKey(const Key& key, TimePoint now, OperatorHands& hands,
                    Duration hold = kKeyHoldTime);

}  // namespace eod::box
