#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <Eigen/Core>

namespace eod::sim {

class TomlTable;

/// One thing the trainee has to do; complete when its condition holds.
struct TaskStep {
  enum class Kind : uint8_t {
    kContact,   ///< touch `object` (any if empty) with an isector, so that the motion is inhibited
    kClear,     ///< no contact, and at least `distance` from where the contact was
    kPassGate,  ///< drive the robot's origin along X of `object`, at most `distance`/2 beside it
    kStopAt,    ///< stand still for 1 s, the foremost point `distance` +- `tolerance` from `object`
    kReach,     ///< origin within `tolerance` of (x, y)
    kGrasp,     ///< hold the movable `object` in the gripper
    kLift,      ///< hold `object` (any if empty) at least `distance` above where it was grasped
    kPlaceInVessel,  ///< a charge rests in the containment vessel `object`
    kDisrupt,        ///< the charge `object` (any if empty) is shot apart by the disrupter
    kClimb,          ///< origin at least `distance` high, within `tolerance` of (x, y)
    kHoldStill,      ///< stand still for `time`, tilted by at least `tilt`
    kRetreat,        ///< origin at least `distance` from `object`, as seen on the map
    kInspect,        ///< see `object` by a camera that is shown, for `time`
  };
  Kind kind = Kind::kContact;
  std::string object;
  double distance = 0;   ///< [m]; of a gate: width of its opening
  double tolerance = 0;  ///< [m]
  double x = 0, y = 0;   ///< [m] local
  double time = 0;       ///< [s]
  double tilt = 0;       ///< [rad] between the robot's and the world's vertical
  /// Of inspect: what to see in the object's frame [m]; none: its origin, which its own surface
  /// does not hide.
  std::optional<Eigen::Vector3d> point;
  int camera = 0;       ///< of inspect: 1 drive, 2 gripper, 3 mast, 4 rear; 0 any
  bool strict = false;  ///< done before its turn, it ends the exercise
  std::string text;     ///< for the trainee
  double weight = 1;
  unsigned line = 0;  ///< of the file, for errors; 0: unknown
};

/// Reads a [[step]]. Throws "FILE:LINE: …".
TaskStep ReadTaskStep(const TomlTable& table);

}  // namespace eod::sim
