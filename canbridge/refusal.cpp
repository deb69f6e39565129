#include "canbridge/refusal.h"

#include <algorithm>
#include <array>

namespace eod::bridge {
namespace {

using dbc::InhibitReason;

struct Row {
  InhibitReason reason;
  std::string_view text;
};

Row RowOf(Refusal refusal) {
  switch (refusal) {
    case Refusal::kNone:
      return {InhibitReason::kNone, ""};
    case Refusal::kForeignRobot:
      return {InhibitReason::kLinkLoss,
              "another robot sends on this bus: this bridge is silent until it is restarted"};
    case Refusal::kBusDown:
      return {InhibitReason::kLinkLoss, "CAN bus is down"};
    case Refusal::kBusOff:
      return {InhibitReason::kLinkLoss, "CAN controller is bus-off"};
    case Refusal::kEstop:
      return {InhibitReason::kEstop,
              "emergency stop is latched: release it, all controls neutral, Reset, then Start"};
    case Refusal::kRobotEstop:
      return {InhibitReason::kEstop,
              "emergency stop on the robot itself is latched: release it, then Reset, Start"};
    case Refusal::kEstopContradiction:
      return {InhibitReason::kEstop,
              "box fault: emergency stop channels contradict each other; then Reset, Start"};
    case Refusal::kBoxFault:
      return {InhibitReason::kNotReady,
              "box fault: the control box reports a fault of its own; then Reset, Start"};
    case Refusal::kCrcFault:
      return {InhibitReason::kLinkLoss, "link fault: too many wrong CRCs; Reset, then Start"};
    case Refusal::kLinkLatched:
      return {InhibitReason::kLinkLoss,
              "link fault: no valid box frames for more than 500 ms; Reset, then Start"};
    case Refusal::kRobotLinkLatched:
      return {InhibitReason::kLinkLoss,
              "the robot heard no command for more than 500 ms; Reset, then Start"};
    case Refusal::kSafetyLost:
      return {InhibitReason::kLinkLoss, "link lost: no valid safety frame for more than 100 ms"};
    case Refusal::kMotionLost:
      return {InhibitReason::kLinkLoss, "link lost: no valid motion frame for more than 100 ms"};
    case Refusal::kAxesLost:
      return {InhibitReason::kLinkLoss,
              "link lost: no valid axes frame for more than 100 ms with a stick deflected"};
    case Refusal::kHeartbeatLost:
      return {InhibitReason::kLinkLoss, "link lost: no box heartbeat for more than 600 ms"};
    case Refusal::kNoBox:
      return {InhibitReason::kNotReady, "no control box on the bus yet"};
    case Refusal::kSimulatorSilent:
      return {InhibitReason::kNotReady, "no robot state from the simulator"};
    case Refusal::kKey:
      return {InhibitReason::kNotReady, "key switch is not at Operate"};
    case Refusal::kEstopUnclear:
      return {InhibitReason::kEstop, "emergency stop channels disagree"};
    case Refusal::kNotOperational:
      return {InhibitReason::kNotReady, "heartbeat says that the control box is not operational"};
    case Refusal::kSignalInvalid:
      return {InhibitReason::kNotReady, "a mode, range or stick signal is invalid"};
    case Refusal::kStartNeeded:
      return {InhibitReason::kNotReady, "reset is done: press Start"};
    case Refusal::kDeadman:
      return {InhibitReason::kDeadman, "enabling switch is not held"};
    case Refusal::kNeutralNeeded:
      return {InhibitReason::kNeutralNeeded, "release all buttons and sticks first"};
  }
  return {InhibitReason::kNotReady, "unknown"};
}

constexpr std::array kGravestFirst{
    InhibitReason::kEstop,    InhibitReason::kLinkLoss,      InhibitReason::kTilt,
    InhibitReason::kPayload,  InhibitReason::kCollision,     InhibitReason::kJointLimit,
    InhibitReason::kConflict, InhibitReason::kCable,         InhibitReason::kNotReady,
    InhibitReason::kDeadman,  InhibitReason::kNeutralNeeded, InhibitReason::kNone};

}  // namespace

InhibitReason ReasonOf(Refusal refusal) { return RowOf(refusal).reason; }

std::string_view TextOf(Refusal refusal) { return RowOf(refusal).text; }

InhibitReason Gravest(InhibitReason a, InhibitReason b) {
  return std::ranges::find(kGravestFirst, a) < std::ranges::find(kGravestFirst, b) ? a : b;
}

}  // namespace eod::bridge
