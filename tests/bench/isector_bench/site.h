#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "sim/geometry/mesh.h"

namespace eod::bench {

/// The site that the robot drives through, in a frame S of its own: U along the long side of its
/// loop, V along the short one, Z up. It lies 1.7 km from the module's origin, and turned by 20
/// degrees, so that nothing of it is parallel to the module's axes.
inline const Eigen::Vector2d kSiteCentre(1202, 1202);  ///< in M [m]

/// Half lengths of the loop's straight sides and the radius of its corners [m]. Once round is
/// 53.6 m: what 2000 frames at 25 Hz and 0.67 m/s cover.
inline constexpr double kHalfStraightU = 8.25, kHalfStraightV = 3.579, kCornerRadius = 1.0;
/// Path of the robot's middle along the long sides: V = -+kLoopV.
inline constexpr double kLoopV = kHalfStraightV + kCornerRadius;
inline constexpr double kLoopU = kHalfStraightU + kCornerRadius;

/// Half lengths of the area that is the site's own; things at random stay outside.
inline constexpr double kSiteHalfU = 13, kSiteHalfV = 9;

/// Pose of S in M; its height is the ground's in the middle.
Eigen::Isometry3d SitePose();

/// Height of the rolling ground at (x, y) of M [m]: hills of 3 m on 60 m, swells of 0.15 m on 6 m,
/// bumps of 3 cm on 1.1 m, at most about 15 degrees steep. Needs no library function that rounds.
double GroundHeight(double x, double y);

/// What the robot's tracks lie on at (x, y) of M [m]: the ground, or the line over the nosings of
/// the stairs and the landing between them.
double SupportHeight(double x, double y);

struct SiteObject {
  std::string name;
  sim::Mesh mesh;  ///< in M
};

/// Walls, a gate, kerbs, two flights of stairs, a corridor with a low ceiling, clutter.
std::vector<SiteObject> SiteObjects();

}  // namespace eod::bench
