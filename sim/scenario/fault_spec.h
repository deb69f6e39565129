#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace eod::sim {

class TomlTable;

/// Something that breaks during an exercise. The trainee is not told; the log is.
struct FaultSpec {
  enum class Kind : uint8_t {
    kCameraDead,
    kCameraFrozen,
    kCameraNoisy,
    kCameraWrongLight,
    kJointStuck,
    kJointSlow,   ///< `amount` of its rate is left
    kJointDrift,  ///< `amount` [deg/s], J7 [mm/s], without a command
    kTrackWeak,   ///< `amount` of the speed of the track `target` is left
    kGripperSlip,
    kBatterySag,    ///< by `amount` [V]
    kRadioLoss,     ///< nothing gets through
    kCableSnag,     ///< no cable runs out any more
    kFieldEstop,    ///< someone in the field pressed the robot's emergency stop
    kStuckButton,   ///< the motion `target` is commanded without a finger
    kSensorOffset,  ///< the displayed angle of joint `target` is off by `amount` [deg]
    kLampBroken,    ///< the box's lamp `target` stays dark
  };
  Kind kind = Kind::kCameraDead;
  /// camera, J1..J9, "left" or "right", M01..M22, lamp; "" where none is meant
  std::string target = {};
  double amount = 0;
  /// It begins at a moment of the mission [s], or when a step is complete (1: the first), or when a
  /// charge is in the gripper.
  std::optional<double> at = {};
  int after_step = 0;
  bool on_grasp = false;
  double duration = 0;  ///< [s] 0: until the end
  unsigned line = 1;    ///< of the file, for what is wrong with it
  bool operator==(const FaultSpec&) const = default;
};

/// As scenario files call it.
std::string_view NameOf(FaultSpec::Kind kind);

/// Reads a [[fault]]. Throws "FILE:LINE: …".
FaultSpec ReadFaultSpec(const TomlTable& table);

}  // namespace eod::sim
