#include "sim/bodies/mass_properties.h"

#include <numbers>

#include <Eigen/Eigenvalues>

namespace eod::sim {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

/// Volume, and inertia of density 1 about the centre; diagonal in the solid's frame.
struct VolumeMoments {
  double volume = 0;
  Vector3d inertia = Vector3d::Zero();
};

struct MomentsOf {
  VolumeMoments operator()(const BoxSolid& box) const {
    const Vector3d s = box.half.cwiseAbs2();
    const double volume = 8 * box.half.prod();
    return {volume, volume / 3 * Vector3d(s.y() + s.z(), s.x() + s.z(), s.x() + s.y())};
  }
  VolumeMoments operator()(const CylinderSolid& cylinder) const {
    const double r2 = cylinder.radius * cylinder.radius, h = cylinder.half_length;
    const double volume = 2 * pi * r2 * h, across = volume * (r2 / 4 + h * h / 3);
    return {volume, {across, across, volume * r2 / 2}};
  }
  VolumeMoments operator()(const SphereSolid& sphere) const {
    const double r2 = sphere.radius * sphere.radius;
    const double volume = 4 * pi / 3 * r2 * sphere.radius;
    return {volume, Vector3d::Constant(0.4 * volume * r2)};
  }
  VolumeMoments operator()(const CapsuleSolid& capsule) const {
    const double r = capsule.radius, h = capsule.half_length;
    const VolumeMoments straight = (*this)(CylinderSolid{r, h}), ball = (*this)(SphereSolid{r});
    // A half ball has its centre 3/8 r beyond the end of the straight part.
    const double shift = ball.volume * (h * h + 0.75 * r * h);
    return {straight.volume + ball.volume,
            straight.inertia + ball.inertia + Vector3d(shift, shift, 0)};
  }
  VolumeMoments operator()(const HullSolid& hull) const {
    Eigen::AlignedBox3d box;
    for (const Vector3d& corner : hull.corners) box.extend(corner);
    return (*this)(BoxSolid{box.sizes() / 2});
  }
};

}  // namespace

MassProperties MassPropertiesOf(const MovableObject& object) {
  double volume = 0;
  Matrix3d inertia = Matrix3d::Zero();
  for (const MovablePart& part : object.parts) {
    const VolumeMoments own = std::visit(MomentsOf{}, part.shape.solid());
    const Matrix3d R = part.X_OS.linear();
    const Vector3d d = part.X_OS.translation() - object.p_OC;
    inertia += R * own.inertia.asDiagonal() * R.transpose();
    inertia += own.volume * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    volume += own.volume;
  }
  inertia *= object.mass / volume;
  MassProperties result;
  result.X_OB.translation() = object.p_OC;
  const Matrix3d crossed = inertia - Matrix3d(inertia.diagonal().asDiagonal());
  if (crossed.norm() <= 1e-9 * inertia.norm()) {
    result.inertia = inertia.diagonal();
    return result;
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3d> principal(inertia);
  result.inertia = principal.eigenvalues();
  result.X_OB.linear() = principal.eigenvectors();
  if (result.X_OB.linear().determinant() < 0) result.X_OB.linear().col(0) *= -1;
  return result;
}

}  // namespace eod::sim
