#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "sim/geometry/pose.h"
#include "sim/isectors/isector.h"

namespace eod::sim {

/// What the legs of a TRIPOD met.
struct GroundFix {
  int legs = 0;  ///< how many legs met ground, 0..3
  /// [m] z of the plane under the tripod's origin O; with 1 or 2 legs O.z moved by mean_offset.
  double height = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of the plane, z > 0; legs == 3
  /// [m] mean of (hit z - z of the carrier's own plane at that leg); legs >= 1
  double mean_offset = 0;
};

/// TRIPOD: plane through its hits. A disabled leg meets no ground. Throws StaleReading if it was
/// not cast in `step`, std::invalid_argument if it is of another method.
GroundFix ReadTripod(const Isector& tripod, int64_t step);

/// How something stands that a TRIPOD carries.
struct Footing {
  double z = 0;  ///< [m] of O
  Attitude attitude = {};
  bool falling = false;
  bool operator==(const Footing&) const = default;
};

/// The next footing, at `heading` [rad]. Three legs: height, pitch and roll of the plane. Two: the
/// last normal stays, z moves by the mean offset. One: the last pitch and roll stay, z moves. None:
/// falling; height and attitude stay. Source: missing legs in 1.2 of the design.
Footing NextFooting(const GroundFix& ground, const Footing& last, double heading);

}  // namespace eod::sim
