#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "platform/time.h"

namespace eod::box {

/// Something that stands in the exercise. Local frame of the module: X right, Y forward, Z up at
/// heading 0, [m]; angles [deg].
struct SeenObject {
  std::string name;
  std::array<double, 3> position{};  ///< of a movable its centre of mass
  double heading_deg = 0;
  double tilt_deg = 0;
  bool is_held = false;  ///< in the gripper
  bool is_gone = false;  ///< no longer there
};

/// What a scripted operator sees of the robot and its surroundings, as a person does on pictures or
/// over the fence. The emulated firmware never gets it.
struct Sight {
  /// Older sight [s] counts as none: pictures have stopped.
  static constexpr Duration kLongest = std::chrono::milliseconds(500);

  bool has_robot = false;            ///< and surroundings of the same module
  TimePoint robot_time{};            ///< when the robot was seen last
  TimePoint scene_time{};            ///< when the surroundings were
  std::array<double, 3> position{};  ///< [m] of the robot, local
  double heading_deg = 0;            ///< of the robot, 0..360, counter-clockwise
  double speed_mps = 0;              ///< forward positive
  double turn_rate_dps = 0;          ///< left positive
  std::vector<SeenObject> objects;

  bool IsFresh(TimePoint now) const {
    return has_robot && now - robot_time <= kLongest && now - scene_time <= kLongest;
  }
  /// Null if there is none of that name, or no longer.
  const SeenObject* Find(std::string_view name) const;
};

/// A point as the robot's driver has it, horizontally, whatever the robot's tilt [m].
struct FromRobot {
  double ahead = 0;  ///< of the robot's origin
  double side = 0;   ///< to the right
  double distance() const;
  double bearing_deg() const;  ///< left positive, (-180, 180]; 0: dead ahead
};
FromRobot SeenFromRobot(const Sight& sight, double x, double y);

}  // namespace eod::box
