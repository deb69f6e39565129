#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace eod::sim {

class TomlTable;

/// Something that an exercise measures, and what it is worth: all of its weight at `best`, none at
/// `worst`, in between along a straight line. Lengths in m, angles in rad, or a count.
struct PrecisionSpec {
  enum class Kind : uint8_t {
    kStopError,      ///< [m] mean distance of the stops that stop_at asks for from their marks
    kPathError,      ///< [m] mean distance, over the way driven, of the origin from `points`
    kHeadingError,   ///< [rad] mean, over the way driven, of |heading - `heading`|
    kTiltPeak,       ///< [rad] largest tilt between the robot's and the world's vertical
    kCentringError,  ///< [m] along the fingers, of the charge from the middle of the jaws at a
                     ///< grasp
    kReleaseOffset,  ///< [m] on the map, of the charge from the axis of `objects` when let go of
    kRimClearance,   ///< [m] of the held charge over the rim of the drum `objects` as it comes over
    kPlacementError,  ///< [m] on the map, of the charge from `objects` or `points` at the end
    kContacts,        ///< new contacts with `objects`, or with any
    kWallClearance,   ///< [m] smallest distance of the robot's origin from `points`
    kTurnCount,       ///< turns begun
    kMoved,           ///< [m] farthest of the movables `objects`, or of all, from where it stood
  };
  Kind kind = Kind::kStopError;
  std::string text;  ///< for the report; "" for the name of the kind
  double weight = 1;
  double best = 0;
  double worst = 0;
  int step = 0;  ///< counts only while this step is to be done (1: the first); 0: always
  std::vector<std::string> objects;
  std::vector<Eigen::Vector2d> points;  ///< [m] local; a polyline, or one point
  /// Counts only while the robot's origin is within x0, y0, x1, y1 [m], local.
  std::optional<Eigen::Vector4d> box;
  double heading = 0;  ///< [rad]
};

/// Name of the kind, as in the file.
std::string_view NameOf(PrecisionSpec::Kind kind);
/// Unit of what it measures in the file and in reports: "m", "deg", or "" for a count.
std::string_view UnitOf(PrecisionSpec::Kind kind);

/// Reads a [[precision]]. Throws "FILE:LINE: …".
PrecisionSpec ReadPrecisionSpec(const TomlTable& table);

}  // namespace eod::sim
