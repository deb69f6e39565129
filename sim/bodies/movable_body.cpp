#include "sim/bodies/movable_body.h"

#include <numbers>

namespace eod::sim {

namespace {

// A thing that for two seconds (Bullet's own time) stays within this is at rest. By pose, not by
// speed: where contact points come and go, speeds jump and poses do not.
constexpr double kRestShift = 1e-3;  // [m]
constexpr double kRestTurn = 0.01;   // [rad]
constexpr double kAnySpeed = 1e6;    // so that Bullet does not judge by speed

}  // namespace

Eigen::Isometry3d PoseBefore(const Eigen::Isometry3d& X_now, const Eigen::Isometry3d& X_next) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = X_now.linear() * X_next.linear().transpose() * X_now.linear();
  X.translation() = 2 * X_now.translation() - X_next.translation();
  return X;
}

MovableBody::MovableBody(const MovableObject& object) : mass_(object.mass) {
  const MassProperties properties = MassPropertiesOf(object);
  inertia_ = ToBullet(properties.inertia);
  X_OB_ = properties.X_OB;
  X_BO_ = X_OB_.inverse();
  for (const MovablePart& part : object.parts) {
    parts_.push_back(std::visit(BulletShapeOf{kSolidMargin}, part.shape.solid()));
    if (std::holds_alternative<BoxSolid>(part.shape.solid())) {
      parts_.back()->setMargin(kSolidMargin);
    }
  }
  btCollisionShape* shape = parts_[0].get();
  const Eigen::Isometry3d X_BS = X_BO_ * object.parts[0].X_OS;
  if (parts_.size() > 1 || !X_BS.isApprox(Eigen::Isometry3d::Identity(), 1e-12)) {
    compound_ = std::make_unique<btCompoundShape>(true, static_cast<int>(parts_.size()));
    for (size_t i = 0; i < parts_.size(); ++i) {
      compound_->addChildShape(ToBullet(X_BO_ * object.parts[i].X_OS), parts_[i].get());
    }
    shape = compound_.get();
  }
  btRigidBody::btRigidBodyConstructionInfo info(mass_, nullptr, shape, inertia_);
  info.m_startWorldTransform = ToBodyFrame(object.X_MO);
  info.m_friction = object.friction;
  info.m_rollingFriction = object.rolling;
  info.m_restitution = 0;
  info.m_linearSleepingThreshold = kAnySpeed;
  info.m_angularSleepingThreshold = kAnySpeed;
  body_ = std::make_unique<btRigidBody>(info);
  body_->forceActivationState(ISLAND_SLEEPING);
}

Eigen::Vector3d MovableBody::Velocity(const Eigen::Isometry3d& X_MO) const {
  const btVector3 lever =
      ToBullet(Eigen::Vector3d(X_MO.translation())) - body_->getCenterOfMassPosition();
  return FromBullet(body_->getVelocityInLocalPoint(lever));
}

void MovableBody::WatchRest(const Eigen::Isometry3d& X_MO) {
  const double shift = (X_MO.translation() - X_rest_.translation()).norm();
  // For small angles the matrices differ by sqrt(2) times the angle.
  const double turn = (X_MO.linear() - X_rest_.linear()).norm() / std::numbers::sqrt2;
  if (shift <= kRestShift && turn <= kRestTurn) return;
  X_rest_ = X_MO;
  body_->setDeactivationTime(0);
  body_->forceActivationState(ACTIVE_TAG);
}

void MovableBody::Hold() {
  body_->setMassProps(0, btVector3(0, 0, 0));
  body_->setCollisionFlags(body_->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  body_->forceActivationState(DISABLE_DEACTIVATION);
  body_->clearForces();
}

void MovableBody::Release(const Eigen::Isometry3d& X_from, const Eigen::Isometry3d& X_to,
                          double dt_s) {
  body_->setCollisionFlags(body_->getCollisionFlags() & ~btCollisionObject::CF_KINEMATIC_OBJECT);
  body_->setMassProps(mass_, inertia_);
  body_->setWorldTransform(ToBodyFrame(X_to));
  body_->setInterpolationWorldTransform(body_->getWorldTransform());
  body_->updateInertiaTensor();
  btVector3 v(0, 0, 0), w(0, 0, 0);
  if (dt_s > 0) {
    btTransformUtil::calculateVelocity(ToBodyFrame(X_from), body_->getWorldTransform(), dt_s, v, w);
  }
  body_->setLinearVelocity(v);
  body_->setAngularVelocity(w);
  body_->forceActivationState(ACTIVE_TAG);
  body_->setDeactivationTime(0);
}

}  // namespace eod::sim
