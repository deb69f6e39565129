#pragma once

#include <array>
#include <cstdint>

#include "sim/robot/motion_id.h"

namespace eod::sim {

/// What may be wrong with a camera at the same time: bits of ActiveFaults::camera.
enum CameraFaultBit : uint8_t {
  kCameraDeadBit = 1,
  kCameraFrozenBit = 2,
  kCameraNoisyBit = 4,
  kCameraWrongLightBit = 8,
};

/// What is broken in a step. Plain data; a new one says that nothing is.
struct ActiveFaults {
  static constexpr int kMostCameras = 8;

  std::array<uint8_t, kMostCameras> camera{};  ///< CameraFaultBit, in the order of the robot's
  uint32_t stuck_joints = 0;                   ///< bit j is joint j
  std::array<double, kJointCount> joint_share{1, 1, 1, 1, 1, 1, 1, 1, 1};  ///< of its rate is left
  std::array<double, kJointCount> joint_drift{};                           ///< [rad/s], J7 [m/s]
  std::array<double, kJointCount> joint_offset{};  ///< of what is displayed [rad], J7 [m]
  double left_track = 1;                           ///< share of the track's speed that is left
  double right_track = 1;
  bool gripper_slips = false;
  double battery_sag = 0;  ///< [V]
  bool silent = false;     ///< nothing gets through between operator and robot
  bool snagged = false;    ///< no more cable pays out
  bool field_estop = false;
  MotionSet stuck_buttons = 0;
  uint32_t dark_lamps = 0;  ///< bit i is lamp i of the box
  bool operator==(const ActiveFaults&) const = default;
};

}  // namespace eod::sim
