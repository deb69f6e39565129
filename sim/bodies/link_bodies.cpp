#include "sim/bodies/link_bodies.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "sim/bodies/movable_body.h"

namespace eod::sim {

namespace {

using Eigen::AlignedBox3d;
using Eigen::Isometry3d;
using Eigen::Vector3d;

// Friction is the movable's affair: Bullet multiplies both.
constexpr double kFullFriction = 1;

constexpr uint32_t BitOf(Part part) { return 1u << static_cast<int>(part); }

struct NamedParts {
  std::string_view link;
  uint32_t parts;
};
constexpr std::array kPartsOfLinks = {
    NamedParts{"front_flipper", BitOf(Part::kFrontLeftWheel) | BitOf(Part::kFrontRightWheel)},
    NamedParts{"rear_flipper", BitOf(Part::kRearLeftWheel) | BitOf(Part::kRearRightWheel)},
    NamedParts{"big_arm", BitOf(Part::kBigArm)},
    NamedParts{"small_arm", BitOf(Part::kSmallArm)},
    NamedParts{"crossbeam", BitOf(Part::kCrossbeam)},
    NamedParts{"gripper", BitOf(Part::kCrossbeam)},
    NamedParts{"left_hand", BitOf(Part::kLeftHand)},
    NamedParts{"right_hand", BitOf(Part::kRightHand)},
    NamedParts{"camera_pan", BitOf(Part::kMast)},
};

/// A link without a name of its own counts as what it hangs on.
uint32_t PartsOf(const RobotModel& robot, int link) {
  for (; link > 0; link = robot.links[static_cast<size_t>(link)].parent) {
    for (const NamedParts& named : kPartsOfLinks) {
      if (named.link == robot.links[static_cast<size_t>(link)].name) return named.parts;
    }
  }
  return BitOf(Part::kChassis);
}

double SquaredDistance(const AlignedBox3d& box, const Vector3d& point) {
  return (box.min() - point).cwiseMax(point - box.max()).cwiseMax(0).squaredNorm();
}

bool IsSame(const Isometry3d& a, const Isometry3d& b) { return a.matrix() == b.matrix(); }

}  // namespace

LinkBodies::LinkBodies(const RobotModel& robot)
    : last_(robot.links.size(), Isometry3d::Identity()),
      in_bullet_(robot.links.size(), Isometry3d::Identity()) {
  for (size_t i = 0; i < robot.links.size(); ++i) {
    const int link = static_cast<int>(i);
    AlignedBox3d around;
    for (const LinkSolid& one : robot.links[i].solids) {
      Solid solid{link, PartsOf(robot, link), one.X_LS,
                  std::visit(BulletShapeOf{kSolidMargin}, one.shape.solid()), nullptr};
      if (std::holds_alternative<BoxSolid>(one.shape.solid())) solid.shape->setMargin(kSolidMargin);
      around.extend(one.shape.Bounds(one.X_LS));
      solids_.push_back(std::move(solid));
    }
    if (!around.isEmpty()) balls_.push_back({link, around.center(), around.diagonal().norm() / 2});
  }
  Rebuild();
}

void LinkBodies::Rebuild() {
  for (Solid& solid : solids_) {
    btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, solid.shape.get());
    info.m_friction = kFullFriction;
    solid.body = std::make_unique<btRigidBody>(info);
    solid.body->setCollisionFlags(solid.body->getCollisionFlags() |
                                  btCollisionObject::CF_KINEMATIC_OBJECT);
  }
  placed_ = remembered_ = false;
}

bool LinkBodies::StandsAt(std::span<const Isometry3d> X_ML) const {
  return remembered_ && std::equal(X_ML.begin(), X_ML.end(), last_.begin(), last_.end(), IsSame);
}

bool LinkBodies::IsNear(std::span<const Isometry3d> X_ML, std::span<const AlignedBox3d> boxes,
                        double margin) const {
  AlignedBox3d robot;
  for (const Ball& ball : balls_) {
    const Vector3d centre = X_ML[static_cast<size_t>(ball.link)] * ball.centre;
    const Vector3d reach = Vector3d::Constant(ball.radius + margin);
    robot.extend(centre - reach);
    robot.extend(centre + reach);
  }
  for (const AlignedBox3d& box : boxes) {
    if (box.isEmpty() || !robot.intersects(box)) continue;
    for (const Ball& ball : balls_) {
      const double reach = ball.radius + margin;
      const Vector3d centre = X_ML[static_cast<size_t>(ball.link)] * ball.centre;
      if (SquaredDistance(box, centre) > reach * reach) continue;
      if (IsSolidNear(X_ML, ball.link, box, margin)) return true;
    }
  }
  return false;
}

bool LinkBodies::IsSolidNear(std::span<const Isometry3d> X_ML, int link, const AlignedBox3d& box,
                             double margin) const {
  for (const Solid& solid : solids_) {
    if (solid.link != link) continue;
    btVector3 low, high;
    solid.shape->getAabb(ToBullet(X_ML[static_cast<size_t>(link)] * solid.X_LS), low, high);
    const Vector3d reach = Vector3d::Constant(margin);
    if (box.intersects(AlignedBox3d(FromBullet(low) - reach, FromBullet(high) + reach))) {
      return true;
    }
  }
  return false;
}

void LinkBodies::Follow(std::span<const Isometry3d> X_ML) {
  if (!remembered_) std::copy(X_ML.begin(), X_ML.end(), last_.begin());
  for (Solid& solid : solids_) {
    const auto link = static_cast<size_t>(solid.link);
    btRigidBody& body = *solid.body;
    const bool moves = !IsSame(last_[link], X_ML[link]);
    const bool is_there = placed_ && IsSame(in_bullet_[link], last_[link]);
    const Isometry3d X_MS = last_[link] * solid.X_LS;
    if (!is_there) body.setWorldTransform(ToBullet(X_MS));
    body.setInterpolationWorldTransform(moves ? ToBullet(PoseBefore(X_MS, X_ML[link] * solid.X_LS))
                                              : body.getWorldTransform());
    if (!moves) {
      body.setLinearVelocity(btVector3(0, 0, 0));
      body.setAngularVelocity(btVector3(0, 0, 0));
    }
    body.forceActivationState(moves || !is_there ? ACTIVE_TAG : ISLAND_SLEEPING);
  }
  std::copy(last_.begin(), last_.end(), in_bullet_.begin());
  placed_ = true;
}

void LinkBodies::Remember(std::span<const Isometry3d> X_ML) {
  std::copy(X_ML.begin(), X_ML.end(), last_.begin());
  remembered_ = true;
}

}  // namespace eod::sim
