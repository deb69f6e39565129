#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace eod::sim {

/// Half-space of the points p with normal.p <= offset.
struct HullPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, outward
  double offset = 0;                                  ///< [m]
};

/// The smallest convex solid round some points, in their frame.
struct ConvexHull {
  std::vector<Eigen::Vector3d> corners;  ///< all of them; some more may lie in faces
  std::vector<HullPlane> planes;         ///< one a face; the solid is what lies within all of them
};

/// Hull of any number of points, in any order, doubled or inside ones included. Exact to 1e-12 of
/// its largest extent, and it always holds every point. Time grows as points times faces.
/// Throws std::runtime_error if a point is not finite, or if the points have no volume: thinner
/// than a millionth of their extent.
ConvexHull HullOf(std::span<const Eigen::Vector3d> points);

}  // namespace eod::sim
