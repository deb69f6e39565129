#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace eod::sim {

/// Numbers of ROB_JOINT_C.GraspState.
enum class GraspState : int8_t {
  kOpen,
  kClosing,
  kContactLeft,
  kContactRight,
  kContactBoth,
  kGrasped,
  kSlipping,
  kReleased
};

/// Numbers of ROB_MISSION.BombState.
enum class BombState : int8_t {
  kNone,
  kPlaced,
  kTouched,
  kTilted,
  kGrasped,
  kCarried,
  kDropped,
  kInCan,
  kExploded,
  kDisrupted
};

/// Numbers of ROB_FIRE.FireState.
enum class FireState : int8_t { kSafe, kArmedWait, kReady, kFired, kFault, kTimeOut };

/// Why a charge went off; for the log and the instructor.
enum class DetonationCause : int8_t {
  kNone,
  kTipped,
  kDropped,
  kSqueezed,
  kRimStrike,
  kShot,    ///< the disrupter set it off
  kCrushed  ///< the robot rolled over or fell with it
};

/// The fire panel as it came from the box. It acts inside the simulator only.
struct FirePanel {
  int arm_key = 0;     ///< contact: 0 or 3 fault, 1 safe, 2 armed
  int fire_left = 0;   ///< contact: 0 or 3 fault, 1 released, 2 pressed
  int fire_right = 0;  ///< the same
  int circuit = 0;     ///< 0 none, 1..3
  int nonce_echo = 0;  ///< 0..255, as the box read it from ROB_FIRE
  bool operator==(const FirePanel&) const = default;
};

/// What a step found about charges, gripper and disrupter. Copyable, comparable.
struct DisposalStatus {
  GraspState grasp = GraspState::kOpen;
  int held_body = -1;                 ///< index in ModuleModel::movables; -1: nothing
  BombState bomb = BombState::kNone;  ///< of the charge that matters now; none in a module without
  int bomb_body = -1;                 ///< that charge
  double bomb_tilt = 0;               ///< [rad] of its axis against the vertical
  bool touched = false;               ///< a charge is in contact with the robot, and not held
  bool disturbed = false;             ///< tilted beyond the first limit, not held
  bool unstable = false;              ///< tilted beyond the second one
  DetonationCause detonation = DetonationCause::kNone;  ///< stays until the module is entered anew
  Eigen::Vector3d detonation_point = Eigen::Vector3d::Zero();  ///< [m] in the module's frame
  /// On what lies below that: ground, table, net; where fire and smoke come from
  Eigen::Vector3d detonation_ground = Eigen::Vector3d::Zero();
  bool robot_destroyed = false;  ///< it was too near: dead until the module is entered anew
  FireState fire = FireState::kSafe;
  int fire_nonce = 0;          ///< 0..255, to be echoed by the box
  int circuit_continuity = 0;  ///< bit c-1: circuit c has its cartridge
  bool operator==(const DisposalStatus&) const = default;
};

}  // namespace eod::sim
