#pragma once

#include <cstdint>

namespace eod::sim {

inline constexpr int kMotionCount = 22;
inline constexpr int kJointCount = 9;

/// Index of a motion: M01 is 0. Even and odd neighbours are opposites: `motion ^ 1`.
enum MotionId : int {
  kDriveForward,
  kDriveReverse,
  kTurnLeft,
  kTurnRight,
  kFrontFlipperUp,
  kFrontFlipperDown,
  kRearFlipperUp,
  kRearFlipperDown,
  kBigArmUp,
  kBigArmDown,
  kSmallArmUp,
  kSmallArmDown,
  kWristUp,
  kWristDown,
  kGripperCcw,
  kGripperCw,
  kGripperOpen,
  kGripperClose,
  kCameraPanLeft,
  kCameraPanRight,
  kCameraTiltUp,
  kCameraTiltDown,
};

/// Set of motions: bit m is motion m (M01 is bit 0).
using MotionSet = uint32_t;
inline constexpr MotionSet kAllMotions = (1u << kMotionCount) - 1;
/// Beside motions, in the sets that an isector is loaded by: cast even while nothing is commanded.
inline constexpr MotionSet kAlways = 1u << 31;
constexpr MotionSet SetOf(int motion) { return 1u << motion; }
/// M01 to M04.
inline constexpr MotionSet kChassisMotions =
    SetOf(kDriveForward) | SetOf(kDriveReverse) | SetOf(kTurnLeft) | SetOf(kTurnRight);
constexpr bool Contains(MotionSet set, int motion) { return (set >> motion & 1u) != 0; }

/// Index of a joint: J1 is 0.
enum JointId : int {
  kFrontFlipper,
  kRearFlipper,
  kBigArm,
  kSmallArm,
  kWrist,
  kGripperRoll,
  kGripperOpening,
  kCameraPan,
  kCameraTilt,
};

/// Robot parts that an alarm names; the bits of ROB_ALARM.HitPart.
enum class Part : int {
  kFrontLeftWheel,
  kFrontRightWheel,
  kRearLeftWheel,
  kRearRightWheel,
  kLeftHand,
  kRightHand,
  kCrossbeam,
  kChassis,
  kBigArm,
  kSmallArm,
  kMast,
  kHeldBomb,
};

}  // namespace eod::sim
