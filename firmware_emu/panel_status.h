#pragma once

#include <array>
#include <cstdint>

#include "dbc/panel_state.h"
#include "dbc/robot_feedback.h"
#include "platform/time.h"

namespace eod::box {

/// What the box is doing; values as in panel_status_t BOX_*.
enum class BoxState : uint8_t {
  kBoot,          ///< powered, firmware starting, silent
  kSelfTest,      ///< heartbeat pre-operational, all lamps lit, controls must be neutral
  kStandby,       ///< key not in Operate
  kReady,         ///< key in Operate, the robot does not move yet
  kOperate,       ///< the robot obeys
  kEstopLatched,  ///< e-stop pressed, or released and not reset yet, or the robot says so
  kLinkLost,      ///< no valid robot frame for the link time-out
  kFault,         ///< BoxFault other than none
  kOff,           ///< no power
};

/// BOX_SAFETY.BoxFault of this box.
enum class BoxFault : uint8_t {
  kNone = 0,
  kStuckControl = 1,   ///< held at power-up, not let go yet
  kEstopChannels = 2,  ///< antivalent contacts agree for too long
  kAxis = 3,           ///< a stick's converter gives no value
};

/// Everything the box shows, and how its link is.
struct PanelStatus {
  BoxState state = BoxState::kOff;
  BoxFault fault = BoxFault::kNone;
  bool link_up = false;         ///< a valid robot frame within the link time-out
  dbc::PanelState reported;     ///< what the box says on the bus
  dbc::RobotFeedback feedback;  ///< what the robot said last
  TimePoint pose_time{};        ///< when it last told its pose
  std::array<dbc::LampPattern, dbc::kLampCount> lamp{};
  std::array<bool, dbc::kLampCount>
      lit{};  ///< at this moment: blink phase and lamp test counted in
  dbc::BuzzerPattern buzzer = dbc::BuzzerPattern::kOff;
  bool is_sounding = false;

  // Counters since the object was made.
  uint64_t rx = 0;               ///< robot frames accepted
  uint64_t crc_errors = 0;       ///< robot frames dropped for their CRC
  uint64_t sequence_errors = 0;  ///< dropped for a repeated or wrong counter
  uint64_t length_errors = 0;    ///< dropped for being short
  uint64_t foreign_frames = 0;   ///< frames that are not for the box
  uint64_t tx = 0;               ///< frames made
  uint64_t skipped = 0;          ///< cyclic frames left out because ticks stopped for over a cycle
  Duration late{};               ///< delay of this tick's cyclic frames against their schedule
  Duration max_late{};           ///< the largest so far
};

}  // namespace eod::box
