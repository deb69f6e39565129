#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace eod::sim {

class TomlTable;

/// Where something stands at the start of an exercise, in the module's local frame.
struct Placement {
  std::string object;                       ///< a movable of the module; "" for the robot
  std::optional<Eigen::Vector3d> position;  ///< [m] of its frame; none: where the world has it
  std::optional<double> heading;            ///< [rad] none: as the world has it
  /// How far a repetition may move it either way, evenly: x, y [m], heading [rad].
  Eigen::Vector3d spread = Eigen::Vector3d::Zero();
  /// How far this repetition has moved it: x, y [m], heading [rad]. Not from the file, see Vary.
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  unsigned line = 0;  ///< of the file, for errors; 0: unknown
  bool operator==(const Placement&) const = default;
};

/// Reads [start] or a [[place]]; `object` belongs to the latter alone. Throws "FILE:LINE: …".
Placement ReadPlacement(const TomlTable& table, bool names_object);

}  // namespace eod::sim
