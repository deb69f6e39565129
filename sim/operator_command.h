#pragma once

#include <array>
#include <cstdint>

#include "platform/time.h"
#include "sim/disposal/disposal_status.h"
#include "sim/faults/active_faults.h"
#include "sim/motion/motion.h"
#include "sim/robot/motion_id.h"
#include "sim/robot/robot_lights.h"

namespace eod::sim {

/// Why a motion is inhibited: numbers of box_command_t REASON_*, as far as the simulator gives
/// them.
enum InhibitReason : int {
  kReasonNone = 0,
  kReasonCollision = 1,
  kReasonJointLimit = 2,
  kReasonConflict = 3,
  kReasonLinkLoss = 5,
  kReasonEstop = 6,
  kReasonPayload = 7,
  kReasonTilt = 8,
  kReasonNeutralNeeded = 9,
  kReasonNotReady = 10,
  kReasonCable = 11,
};

/// Numbers of box_command_t.menu_command.
enum MenuCommand : int { kMenuNone, kMenuStart, kMenuPause, kMenuResume, kMenuReset, kMenuEnd };

/// What the operator asks for, as the bridge passed it on.
struct OperatorCommand {
  int32_t sequence = 0;
  TimePoint stamp{};          ///< when it was received, or its link last vouched for it
  TimePoint heard{};          ///< when it was received
  int32_t resets = 0;         ///< that the bridge has accepted
  bool link_latched = false;  ///< the robot heard nothing for too long, and waits for a Reset
  bool motion_permitted = false;
  bool safe_stop = false;  ///< not permitted any more, but the bridge ramps the rates to zero
  std::array<double, kMotionCount> motion_rate{};  ///< 0..1
  MotionSet inhibited = 0;                         ///< refused by the bridge already
  int inhibit_reason = 0;                          ///< box_command_t REASON_*
  int speed_range = 1;                             ///< 0 creep, 1 low, 2 high
  int preset = 0;                                  ///< 0 none, 1 stow .. 7 stair down
  FirePanel fire;
  int system_state = 0;    ///< box_command_t STATE_*
  bool lamp_test = false;  ///< the operator looks whether all lamps light
  bool horn = false;
  int camera_select = 1;  ///< 0 quad, 1 drive, 2 gripper, 3 mast, 4 rear
  RobotLights lights;
  int camera_zoom = 0;    ///< 0 hold, 1 in, 2 out
  int menu_module = 0;    ///< 0 none, 1 flat .. 5 indoor
  int menu_exercise = 0;  ///< 1..15 which of the module, 0 the one that is loaded
  int menu_command = 0;   ///< MenuCommand; acts when it changes
};

/// Motions that a command asks for.
MotionSet AskedMotions(const OperatorCommand& command);

/// What is left of a command that can be trusted.
struct Wish {
  MotionDemand demand;
  MotionSet refused = 0;  ///< asked for, but not to be done
  bool trusted = false;   ///< fresh, and motion is permitted or comes to its end
  int preset = 0;         ///< as OperatorCommand has it, 0 if it must not run
  bool brakes = false;    ///< the rates come down to zero by themselves: obey at once
  int reason = kReasonNone;
};

/// Any doubt means zero motion: neither permitted nor in a safe stop's ramp, `timeout` old or
/// older, an unknown speed range. Opposite motions together are both refused; a rate is clamped to
/// 0..1, and NaN is 0. A preset and a button that moves arm or flippers are refused together.
Wish WishOf(const OperatorCommand& command, TimePoint now, Duration timeout);

/// The same of a robot and a box that `faults` are in: a stuck button asks for its motion wherever
/// motion is permitted, and the emergency stop on the robot refuses everything.
Wish WishOf(const OperatorCommand& command, const ActiveFaults& faults, TimePoint now,
            Duration timeout);

}  // namespace eod::sim
