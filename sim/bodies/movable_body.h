#pragma once

#include <memory>
#include <vector>

#include <btBulletDynamicsCommon.h>

#include "sim/bodies/mass_properties.h"
#include "sim/world/bullet_shapes.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// Bullet's margin of all solids [m]: how far edges are rounded. Shapes that press into each other
/// by less are met by GJK, which is exact; a millimetre of rounding would move the angle at which a
/// charge of 60 mm diameter tips by half a degree, this half as much.
inline constexpr double kSolidMargin = 0.5e-3;

/// Where a thing was a step before `X_now` if it goes on evenly to `X_next`. Bullet takes the
/// velocity of what others move from the pose before and the pose now, and moves it on by itself in
/// thought.
Eigen::Isometry3d PoseBefore(const Eigen::Isometry3d& X_now, const Eigen::Isometry3d& X_next);

/// One movable object as a rigid body of Bullet.
class MovableBody {
 public:
  /// Sleeps where the object starts.
  explicit MovableBody(const MovableObject& object);

  btRigidBody& body() { return *body_; }
  const btRigidBody& body() const { return *body_; }

  Eigen::Isometry3d X_MO() const { return FromBullet(body_->getWorldTransform()) * X_BO_; }
  /// Of the object's origin.
  Eigen::Vector3d Velocity(const Eigen::Isometry3d& X_MO) const;
  btTransform ToBodyFrame(const Eigen::Isometry3d& X_MO) const { return ToBullet(X_MO * X_OB_); }

  /// Tells Bullet whether it moves at all: after two seconds without, all that touch each other
  /// fall asleep. To be called once a step.
  void WatchRest(const Eigen::Isometry3d& X_MO);

  /// Follows poses that others set; nothing pushes it.
  void Hold();
  /// Moves by itself again, with the velocity that leads from one pose to the other in dt_s.
  void Release(const Eigen::Isometry3d& X_from, const Eigen::Isometry3d& X_to, double dt_s);

 private:
  double mass_;
  btVector3 inertia_;
  Eigen::Isometry3d X_OB_, X_BO_;
  Eigen::Isometry3d X_rest_ = Eigen::Isometry3d::Identity();  ///< near which it has been of late
  std::vector<BulletShapePointer> parts_;
  std::unique_ptr<btCompoundShape> compound_;
  std::unique_ptr<btRigidBody> body_;
};

}  // namespace eod::sim
