#pragma once

#include <optional>
#include <variant>

#include <Eigen/Geometry>

#include "sim/segments/convex_hull.h"

namespace eod::sim {

/// Convex solids, each in a frame of its own [m]; all but the hull are centred on its origin.
struct BoxSolid {
  Eigen::Vector3d half = Eigen::Vector3d::Zero();
};
struct CylinderSolid {  ///< along Z
  double radius = 0, half_length = 0;
};
struct SphereSolid {
  double radius = 0;
};
struct CapsuleSolid {  ///< along Z; the half length is that of its straight part
  double radius = 0, half_length = 0;
};
using HullSolid = ConvexHull;
using Solid = std::variant<BoxSolid, CylinderSolid, SphereSolid, CapsuleSolid, HullSolid>;

/// The part of a line inside a convex solid, as ranges along the line, and the outward unit normals
/// where it enters and leaves. On an edge the normal is that of one of its faces.
struct Chord {
  double enter = 0, leave = 0;
  Eigen::Vector3d n_enter = Eigen::Vector3d::UnitZ(), n_leave = Eigen::Vector3d::UnitZ();
};

/// Chord of the line through `start` along `direction` (unit to 1e-6). A line that runs in a face
/// belongs to the solid: it enters and leaves at the rim of that face. A line that passes by within
/// kEndTolerance has a chord of length 0 where it is nearest; one farther off has none.
std::optional<Chord> ChordOf(const Solid& solid, const Eigen::Vector3d& start,
                             const Eigen::Vector3d& direction);

/// How far a point is from the surface (negative inside), and where the surface faces there.
/// Within a nanometre of the surface the distance is exact; far from it, a lower bound.
struct SurfaceNear {
  double distance = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
};
SurfaceNear NearestSurface(const Solid& solid, const Eigen::Vector3d& point);

/// Axis-parallel box in M round the solid at X_MS.
Eigen::AlignedBox3d BoundsOf(const Solid& solid, const Eigen::Isometry3d& X_MS);

}  // namespace eod::sim
