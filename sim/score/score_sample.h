#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include <Eigen/Core>

namespace eod::sim {

/// What a judge knows of one step: all of it stands in robot_state_t, with the same numbers in the
/// same units, so that a recorded run gives the bits of the live one. Views are read during a call.
struct ScoreSample {
  int64_t step = 0;
  int module = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m] of the robot's origin in W
  double heading_deg = 0, pitch_deg = 0, roll_deg = 0;
  double speed_mps = 0, turn_rate_dps = 0;
  std::array<double, 9> joint{};  ///< J1..J9 [deg], J7 [m]
  uint32_t limit_flags = 0;
  uint32_t inhibit_mask = 0;
  uint32_t contact_parts = 0;
  std::string_view held_object;
  int fire_state = 0;

  // Of the command that the step obeyed: numbers of box_command_t.
  int system_state = 0;
  int speed_range = 1;
  int camera_select = 1;
  bool horn = false;
  int arm_key = 0, fire_left = 0, fire_right = 0;
  uint32_t checks = 0;  ///< bits of robot_state_t.checks

  uint32_t wanted_mask = 0;
  uint32_t blocked_mask = 0;
  std::string_view contact_object;
  bool contact_by_held = false;
  double ahead_m = 0;
  std::string_view ahead_object;
  std::string_view charge;
  Eigen::Vector3d charge_position = Eigen::Vector3d::Zero();  ///< [m] in W
  double charge_low_m = 0;                                    ///< [m] z in W
  Eigen::Vector3d charge_in_hand = Eigen::Vector3d::Zero();   ///< [m]
  bool charge_touched = false;
  int bomb_state = 0;  ///< numbers of BombState
  std::span<const double> moved_m;

  int mission_state = 0;  ///< numbers of MissionState
  int mission_step = 0;
  int fail_reason = 0;  ///< numbers of FailReason
  double mission_s = 0;
};

/// Bits of ScoreSample::checks.
enum BoxCheck : uint32_t {
  kEstopTested = 1,
  kLampsTested = 2,
  kDriveCameraSeen = 4,
  kGripperCameraSeen = 8,
  kMastCameraSeen = 16,
  kRearCameraSeen = 32,
};
inline constexpr uint32_t kAllCamerasSeen =
    kDriveCameraSeen | kGripperCameraSeen | kMastCameraSeen | kRearCameraSeen;

}  // namespace eod::sim
