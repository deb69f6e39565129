#pragma once

#include <optional>

#include "sim/geometry/mesh.h"
#include "sim/world/world.h"

namespace eod::sim {

/// A segment made ready for many triangles: axes permuted and sheared so that it runs along +Z.
///
/// Watertight: along an edge or a corner that triangles share, at least one of them is met.
/// Source: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2013, in double.
class PreparedSegment {
 public:
  PreparedSegment(const Eigen::Vector3d& start, const Eigen::Vector3d& direction, double length,
                  FaceRule face_rule);

  /// Range at which the triangle is met, within [0, length]; nothing if it is missed or edge-on.
  std::optional<double> Meet(const Triangle& triangle) const;

 private:
  Eigen::Vector3d start_;
  double length_;
  bool front_only_;
  int x_, y_, z_;  ///< permutation: z_ is the axis of the largest direction component
  double shear_x_, shear_y_, scale_z_;
};

}  // namespace eod::sim
