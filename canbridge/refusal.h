#pragma once

#include <cstdint>
#include <string_view>

#include "dbc/robot_feedback.h"

namespace eod::bridge {

/// Why motion is refused; the first that holds is the one that is told.
enum class Refusal : uint8_t {
  kNone,
  kForeignRobot,
  kBusDown,
  kBusOff,
  kEstop,
  kRobotEstop,
  kEstopContradiction,
  kBoxFault,
  kCrcFault,
  kLinkLatched,
  kRobotLinkLatched,
  kSafetyLost,
  kMotionLost,
  kAxesLost,
  kHeartbeatLost,
  kNoBox,
  kSimulatorSilent,
  kKey,
  kEstopUnclear,
  kNotOperational,
  kSignalInvalid,
  kStartNeeded,
  kDeadman,
  kNeutralNeeded,
};

/// Reason as ROB_STATUS.InhibitReason shows it.
dbc::InhibitReason ReasonOf(Refusal refusal);

/// One line for link_status_t.fault, with the remedy; empty for kNone. Static text.
std::string_view TextOf(Refusal refusal);

/// The graver of two reasons: what hurts people or machine first, what waits for the operator last.
dbc::InhibitReason Gravest(dbc::InhibitReason a, dbc::InhibitReason b);

}  // namespace eod::bridge
