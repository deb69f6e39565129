#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "sim/isectors/isector.h"

namespace eod::sim {

/// Where the vertical segments of ground methods begin and end, from O.z [m]. Robots look from
/// their step-up limit down to where a fall is one; Vega Prime's -5000..5000 finds the roof when
/// indoors.
struct VerticalExtent {
  double z_min = -3.0;
  double z_max = 0.45;
};

/// The eight methods, each at the origin of its frame until it is given a pose. All throw
/// std::invalid_argument as Isector does; an extent that is upside down is a bad length.

/// 1..32 segments of the user's own.
Isector MakeVolume(std::string name, std::vector<IsectorSegment> segments);

/// One vertical segment through O, from O.z + z_max down to O.z + z_min.
Isector MakeHat(std::string name, const VerticalExtent& extent = {});
Isector MakeZ(std::string name, const VerticalExtent& extent = {});
Isector MakeZpr(std::string name, const VerticalExtent& extent = {});
Isector MakeXyzpr(std::string name, const VerticalExtent& extent = {});

/// From O along +Y as far as `range` [m].
Isector MakeLos(std::string name, double range);

/// Vertical legs through three points M, N, P of the isector's frame, in its heading.
Isector MakeTripod(std::string name, const std::array<Eigen::Vector3d, 3>& feet,
                   const VerticalExtent& extent = {});

/// Indices of BUMP's segments.
enum BumpSegment : int { kPlusX, kMinusX, kPlusY, kMinusY, kPlusZ, kMinusZ };

/// Six segments from O along both ways of each axis. `half_length` [m], in the order of
/// BumpSegment, is the length of each from O.
Isector MakeBump(std::string name, const std::array<double, 6>& half_length);

}  // namespace eod::sim
