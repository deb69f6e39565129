#pragma once

#include <Eigen/Geometry>

namespace eod::sim {

/// Attitude of a body. Heading counter-clockwise from +Y, pitch nose up, roll right side down
/// [rad].
struct Attitude {
  double heading = 0;
  double pitch = 0;
  double roll = 0;
  bool operator==(const Attitude&) const = default;
};

/// R = Rz(heading) Rx(pitch) Ry(roll); X right, Y forward, Z up.
Eigen::Matrix3d ToRotation(const Attitude& attitude);

/// Inverse of ToRotation for |pitch| < 90 degrees; heading in [0, 2 pi).
Attitude ToAttitude(const Eigen::Matrix3d& R_WB);

/// Attitude whose up axis is the unit normal `n_W` (z > 0), looking along `heading`.
/// Source: domain formulas p = atan2(-n.f, n.z), r = asin(n.s).
Attitude AttitudeOnPlane(const Eigen::Vector3d& n_W, double heading);

/// Angle between the up axis and the vertical [rad], 0 to pi.
double TiltOf(const Attitude& attitude);

/// Wraps into [0, 2 pi).
double WrapHeading(double angle);

}  // namespace eod::sim
