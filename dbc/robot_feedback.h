#pragma once

#include <array>
#include <cstdint>

#include "dbc/panel_state.h"

namespace eod::dbc {

enum class SystemState : uint8_t {
  kInit,
  kStandby,
  kReady,
  kOperate,
  kSafeStop,
  kEstopLatched,
  kFault,
  kPaused,
  kReplay
};
enum class InhibitReason : uint8_t {
  kNone,
  kCollision,
  kJointLimit,
  kConflict,
  kDeadman,
  kLinkLoss,
  kEstop,
  kPayload,
  kTilt,
  kNeutralNeeded,
  kNotReady,
  kCable  ///< its end is reached, or it pays out no more
};
enum class Lamp : uint8_t {
  kPower,
  kLink,
  kEstop,
  kDeadman,
  kCollision,
  kLimit,
  kTilt,
  kBattery,
  kArmed,
  kFired,
  kGrasp,
  kMission,
  kFault,
  kCamera
};
enum class LampPattern : uint8_t { kOff, kOn, kSlowBlink, kFastBlink };
enum class BuzzerPattern : uint8_t { kOff, kBeep, kSlow, kFast, kContinuous, kSuccess, kFailure };

/// Everything a robot shows on its control box (robot to box).
struct RobotFeedback {
  // ROB_STATUS
  SystemState state = SystemState::kInit;
  Module module = Module::kNone;
  int mission_state = 0;  ///< 0 idle, 1 brief, 2 run, 3 success, 4 fail, 5 abort
  bool is_simulator = true;
  uint32_t inhibit_mask = 0;  ///< bit m-1: motion m is inhibited
  InhibitReason inhibit_reason = InhibitReason::kNone;
  double link_quality = 0;  ///< 0..1
  double box_frame_age_s =
      1.27;  ///< [s] age of the last box frame, saturates at the signal's range
  // ROB_ALARM
  BuzzerPattern buzzer = BuzzerPattern::kOff;
  std::array<LampPattern, kLampCount> lamp{};  ///< indexed by Lamp
  uint32_t hit_parts = 0;                      ///< 12 bit, as robot_state_t.contact_parts
  int alarm_code = 0;                          ///< 0..255
  // ROB_JOINT_A/B/C
  std::array<double, kJointCount> joint{};  ///< J1..J9: [deg]; J7 opening per hand [m]
  uint32_t limit_flags = 0;                 ///< bit j-1
  int grasp_state = 0;
  // ROB_POSE
  double speed_mps = 0;
  double heading_deg = 0;  ///< 0..360
  double pitch_deg = 0;
  double roll_deg = 0;
  // ROB_BATTERY
  double battery_v = 0;
  double battery_a = 0;
  double battery_soc = 0;   ///< 0..1
  double motor_temp_c = 0;  ///< [degree Celsius]
  // ROB_MISSION
  double elapsed_s = 0;
  double score = 0;  ///< 0..100
  int step = 0;
  int steps = 0;
  int bomb_state = 0;
  int fail_reason = 0;
  int collisions = 0;
  // ROB_FIRE
  int fire_state = 0;
  int nonce = 0;
  uint32_t circuit_continuity = 0;  ///< bit c-1: circuit c is continuous
  // ROB_HEARTBEAT
  NmtState nmt = NmtState::kPreOperational;
  // ROB_EMCY
  int error_code = 0;      ///< CANopen emergency error code, 0..0xFFFF; 0 = error reset
  int error_register = 0;  ///< CANopen error register: bit 0 generic, 4 communication, 7 device

  bool operator==(const RobotFeedback&) const = default;
};

}  // namespace eod::dbc
