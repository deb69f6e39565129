#pragma once

#include <cstdint>

namespace eod::sim {

/// Why an exercise has failed. Numbers of ROB_MISSION.FailReason.
enum class FailReason : int8_t {
  kNone,
  kExploded,    ///< a charge went off
  kTimeOut,     ///< the time limit has passed
  kRollover,    ///< the robot lies on its back
  kOutOfArea,   ///< the robot has left the exercise's area
  kLinkLost,    ///< no link for longer than CriticalRules::link_lost
  kEstop,       ///< the instructor's emergency stop
  kInstructor,  ///< the instructor has ended it
  kBombLost,    ///< a charge is where no robot can fetch it
  kWrongOrder,  ///< a strict step was done before its turn
};

/// A set of reasons: bit r is FailReason r.
using FailReasons = uint32_t;
constexpr FailReasons SetOf(FailReason reason) { return 1u << static_cast<unsigned>(reason); }
constexpr bool Contains(FailReasons set, FailReason reason) { return (set & SetOf(reason)) != 0; }
inline constexpr FailReasons kEveryReason = ~FailReasons{0};

}  // namespace eod::sim
