#pragma once

#include <memory>

#include <btBulletCollisionCommon.h>

#include "sim/segments/solid.h"

#ifndef BT_USE_DOUBLE_PRECISION
#error "Bullet's float libraries have the same symbols; link bullet_double"
#endif

namespace eod::sim {

/// Between our words and Bullet's; for the few that link it.

inline btVector3 ToBullet(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
inline Eigen::Vector3d FromBullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

inline btTransform ToBullet(const Eigen::Isometry3d& X_MO) {
  const Eigen::Matrix3d R = X_MO.linear();
  const btMatrix3x3 rotation(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1),
                             R(2, 2));
  return btTransform(rotation, ToBullet(Eigen::Vector3d(X_MO.translation())));
}

inline Eigen::Isometry3d FromBullet(const btTransform& transform) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) X(row, column) = transform.getBasis()[row][column];
  }
  X.translation() = FromBullet(transform.getOrigin());
  return X;
}

using BulletShapePointer = std::unique_ptr<btCollisionShape>;

/// `margin` [m] rounds edges: of cylinders within their size, of hulls outside of it.
struct BulletShapeOf {
  double margin;

  BulletShapePointer operator()(const BoxSolid& box) const {
    return std::make_unique<btBoxShape>(ToBullet(box.half));
  }
  BulletShapePointer operator()(const CylinderSolid& cylinder) const {
    auto shape = std::make_unique<btCylinderShapeZ>(
        btVector3(cylinder.radius, cylinder.radius, cylinder.half_length));
    shape->setMargin(margin);
    return shape;
  }
  BulletShapePointer operator()(const SphereSolid& sphere) const {
    return std::make_unique<btSphereShape>(sphere.radius);
  }
  BulletShapePointer operator()(const CapsuleSolid& capsule) const {
    return std::make_unique<btCapsuleShapeZ>(capsule.radius, 2 * capsule.half_length);
  }
  BulletShapePointer operator()(const HullSolid& hull) const {
    auto shape = std::make_unique<btConvexHullShape>();
    for (const Eigen::Vector3d& corner : hull.corners) shape->addPoint(ToBullet(corner), false);
    shape->recalcLocalAabb();
    shape->setMargin(margin);
    return shape;
  }
};

}  // namespace eod::sim
