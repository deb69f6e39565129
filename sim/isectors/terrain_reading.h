#pragma once

#include <cstdint>
#include <optional>

#include "sim/isectors/isector.h"

namespace eod::sim {

/// What the methods with one vertical segment tell of the terrain below. All are for `step` and
/// throw StaleReading, as Isector does; std::invalid_argument for an isector of another method.
/// Nothing below, within the segment: no value.

/// HAT: O.z - z of the hit [m]; negative if O is below.
std::optional<double> ReadHat(const Isector& hat, int64_t step);

/// Z: z of the hit in the module's local frame [m].
std::optional<double> ReadZ(const Isector& z, int64_t step);

/// ZPR: the polygon that was hit.
struct TerrainPose {
  double z = 0;      ///< [m] module's local frame
  double pitch = 0;  ///< [rad] nose up, in the isector's heading
  double roll = 0;   ///< [rad] right side down
};
std::optional<TerrainPose> ReadZpr(const Isector& zpr, int64_t step);

/// XYZPR: how a follower stands over the polygon that was hit.
struct FollowerPose {
  double height = 0;  ///< [m] of O above the hit; negative if below
  double pitch = 0;   ///< [rad] that aligns the follower, in its own heading
  double roll = 0;    ///< [rad]
};
std::optional<FollowerPose> ReadXyzpr(const Isector& xyzpr, int64_t step);

}  // namespace eod::sim
