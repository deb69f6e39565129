#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/sim/bodies_scene.h"

namespace eod::sim {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kGravity = 9.81;

int StepsOf(double seconds) { return static_cast<int>(std::lround(seconds / kDt)); }

/// A module without a robot nearby.
class Alone {
 public:
  explicit Alone(const ModuleModel& module) : robot_(BoxRobot({1, 1, 1})), dut(module, robot_) {
    away_ = FarAway(robot_);
  }
  void Run(double seconds) {
    for (int i = 0; i < StepsOf(seconds); ++i) dut.Step(kDt, away_);
  }
  /// Until all is at rest; returns false after `longest` seconds.
  bool RunToRest(double longest) {
    for (int i = 0; i < StepsOf(longest); ++i) {
      dut.Step(kDt, away_);
      if (!AnyMoves()) return true;
    }
    return false;
  }
  bool AnyMoves() const {
    return std::any_of(dut.states().begin(), dut.states().end(),
                       [](const BodyState& state) { return state.is_moving; });
  }
  void Wake(int body = 0) { dut.Push(body, Vector3d::Zero(), Vector3d::Zero()); }
  const BodyState& state(size_t body = 0) const { return dut.states()[body]; }

 private:
  RobotModel robot_;
  std::vector<Isometry3d> away_;

 public:
  RigidBodies dut;
};

class Charge : public ::testing::TestWithParam<CylinderSize> {
 protected:
  double a() const { return GetParam().radius; }
  double h() const { return GetParam().height / 2; }
  /// atan(a/h): beyond this tilt the centre of mass is past the edge.
  double TippingAngle() const { return std::atan(a() / h()); }
  /// On flat ground, tilted about the edge of its base.
  ModuleModel Tilted(double angle) const {
    ModuleModel module = GroundOf(20);
    AddCharge(module, GetParam(),
              Translation3d(a(), 0, 0) * AngleAxisd(angle, Vector3d::UnitY()) *
                  Translation3d(-a(), 0, h()));
    return module;
  }
};

INSTANTIATE_TEST_SUITE_P(Trainers, Charge,
                         ::testing::Values(kSmallCharge, kMiddleCharge, kLargeCharge),
                         [](const auto& size) { return std::string(size.param.name); });

TEST_P(Charge, StandsForAMinuteToTheLastBit) {
  ModuleModel module = GroundOf(20);
  AddStandingCharge(module, GetParam(), 0.3, 0.4);
  Alone scene(module);
  scene.Run(60);
  EXPECT_EQ(scene.state().X_MO.matrix(), module.movables[0].X_MO.matrix());
  EXPECT_FALSE(scene.state().is_moving);
}

TEST_P(Charge, WokenItComesToRestWhereItStoodAndStaysThereToTheLastBit) {
  ModuleModel module = GroundOf(20);
  AddStandingCharge(module, GetParam(), 0.3, 0.4);
  Alone scene(module);
  scene.Wake();
  ASSERT_TRUE(scene.RunToRest(10));
  const Isometry3d at_rest = scene.state().X_MO;
  EXPECT_LT((at_rest.translation() - module.movables[0].X_MO.translation()).norm(), 0.2e-3);
  EXPECT_LT(TiltOf(scene.state()), 0.01 * kDegree);
  EXPECT_TRUE(scene.state().touches_ground);
  scene.Run(50);
  EXPECT_EQ(scene.state().X_MO.matrix(), at_rest.matrix());
}

TEST_P(Charge, ReleasedShortOfItsTippingAngleItStandsUpAgain) {
  Alone scene(Tilted(0.93 * TippingAngle()));
  scene.Wake();
  ASSERT_TRUE(scene.RunToRest(20));
  EXPECT_LT(TiltOf(scene.state()), 0.05 * kDegree);
  EXPECT_NEAR(scene.state().X_MO.translation().z(), h(), 0.1e-3);
}

TEST_P(Charge, ReleasedBeyondItsTippingAngleItFallsOver) {
  Alone scene(Tilted(1.07 * TippingAngle()));
  scene.Wake();
  ASSERT_TRUE(scene.RunToRest(20));
  EXPECT_NEAR(TiltOf(scene.state()), 90 * kDegree, 0.2 * kDegree);
  EXPECT_NEAR(scene.state().X_MO.translation().z(), a(), 0.2e-3);
}

TEST_P(Charge, RollsAndComesToRest) {
  ModuleModel module = GroundOf(40);
  AddCharge(module, GetParam(), At(0, 0, a()) * AngleAxisd(90 * kDegree, Vector3d::UnitY()));
  Alone scene(module);
  const double speed = 0.3;
  scene.dut.Push(0, {0, GetParam().mass * speed, 0}, {0, 0, a()});
  scene.Run(1);
  // A blow through the centre leaves a rolling cylinder two thirds of its speed; a couple of
  // m g b brakes its m a^2 3/2.
  EXPECT_NEAR(scene.state().w_M.x(), -scene.state().v_M.y() / a(), 0.1 / a() * speed);
  const double braked = 2.0 / 3 * module.movables[0].rolling / a() * kGravity;
  EXPECT_NEAR(scene.state().v_M.y(), 2 * speed / 3 - braked, 0.1 * speed);
  ASSERT_TRUE(scene.RunToRest(60));
  EXPECT_GT(scene.state().X_MO.translation().y(), 0.1);
  EXPECT_NEAR(TiltOf(scene.state()), 90 * kDegree, 0.2 * kDegree);
}

TEST_P(Charge, FallsFromATableInTheTimeOfFreeFall) {
  const double table = 0.75;
  ModuleModel module = GroundOf(20);
  AddCharge(module, GetParam(), At(0, 0, table + h()));
  Alone scene(module);
  scene.Wake();
  int steps = 0;
  while (!scene.state().touches_ground && steps < StepsOf(2)) {
    scene.Run(kDt);
    ++steps;
  }
  // Contact begins up to one step before the base is down, and is seen one step late at most.
  EXPECT_NEAR(steps * kDt, std::sqrt(2 * table / kGravity), 2.5 * kDt);
  ASSERT_TRUE(scene.RunToRest(10));
  const bool stands = TiltOf(scene.state()) < 45 * kDegree;
  EXPECT_NEAR(scene.state().X_MO.translation().z(), stands ? h() : a(), 0.5e-3);
}

TEST_P(Charge, PushedLowItSlidesAndPushedHighItTips) {
  // A force that overcomes friction, mu m g, at height z tips it about its edge if z mu > a.
  const double edge = a() / kFriction;
  const double low = 0.4 * edge, high = 1.9 * h();
  ASSERT_GT(high, 1.3 * edge);
  for (const double height : {low, high}) {
    ModuleModel module = GroundOf(20);
    AddStandingCharge(module, GetParam(), 0, 0);
    Alone scene(module);
    const double force = 1.1 * kFriction * GetParam().mass * kGravity;
    double most_tilted = 0;
    for (int i = 0; i < StepsOf(0.4); ++i) {
      const Vector3d p_M = scene.state().X_MO * Vector3d(0, 0, height - h());
      scene.dut.Push(0, {0, force * kDt, 0}, p_M);
      scene.Run(kDt);
      most_tilted = std::max(most_tilted, TiltOf(scene.state()));
    }
    if (height == low) {
      EXPECT_LT(most_tilted, 1.5 * kDegree);
      // The tenth of the force that friction leaves.
      const double way = 0.1 * kFriction * kGravity * 0.4 * 0.4 / 2;
      EXPECT_NEAR(scene.state().X_MO.translation().y(), way, 0.25 * way);
    } else {
      EXPECT_GT(most_tilted, 5 * kDegree);
    }
  }
}

/// An open drum with a net in it, of triangles.
ModuleModel DrumWithNet(double radius, double net_z, double rim_z) {
  ModuleModel module = GroundOf(20);
  constexpr int kSides = 24;
  Mesh drum = PlaneMesh(2 * radius, 2 * radius, 0.05);
  for (Triangle& triangle : drum) {
    for (Vector3d& corner : triangle) corner.z() += net_z;
  }
  const auto on_wall = [&](int side, double z) {
    const double angle = 2 * std::numbers::pi * side / kSides;
    return Vector3d(radius * std::cos(angle), radius * std::sin(angle), z);
  };
  for (int i = 0; i < kSides; ++i) {
    drum.push_back({on_wall(i, 0), on_wall(i, rim_z), on_wall(i + 1, 0)});
    drum.push_back({on_wall(i + 1, 0), on_wall(i, rim_z), on_wall(i + 1, rim_z)});
  }
  AddObject(module, "drum", kModuleBomb | kContainmentVessel | kClampProxy | kBumpProxy, drum);
  return module;
}

TEST_P(Charge, ReleasedAboveADrumItComesToRestOnTheNet) {
  const double radius = 0.25, net = 0.65, rim = 1.0;
  ModuleModel module = DrumWithNet(radius, net, rim);
  AddCharge(module, GetParam(),
            At(0.05, 0.02, rim + 0.1 + h()) * AngleAxisd(0.15, Vector3d(1, 0.4, 0).normalized()));
  Alone scene(module);
  scene.Wake();
  ASSERT_TRUE(scene.RunToRest(30));
  const Vector3d centre = scene.state().X_MO.translation();
  EXPECT_LT(centre.head<2>().norm(), radius);
  EXPECT_GT(centre.z(), net);
  EXPECT_LT(centre.z(), net + 2 * h());
  // Its lowest point lies on the net.
  const double tilt = TiltOf(scene.state());
  const double reach = h() * std::abs(std::cos(tilt)) + a() * std::sin(tilt);
  EXPECT_NEAR(centre.z() - reach, net, 1e-3);
}

TEST(RigidBodies, StandOnWhatThingsRunIntoAlone) {
  // Stairs have a ramp that only TRIPOD knows.
  ModuleModel module = GroundOf(20);
  AddObject(module, "ramp", kModuleBomb | kClampProxy, PlaneMesh(4, 4, 1), {0, 0, 0.5});
  AddCharge(module, kMiddleCharge, At(0, 0, 0.55));
  Alone scene(module);
  scene.Wake();
  ASSERT_TRUE(scene.RunToRest(10));
  EXPECT_NEAR(scene.state().X_MO.translation().z(), kMiddleCharge.height / 2, 0.5e-3);
}

TEST(RigidBodies, OneKnocksOverAnother) {
  ModuleModel module = GroundOf(20);
  AddStandingCharge(module, kMiddleCharge, 0, 0);
  const double a = kLargeCharge.radius;
  AddCharge(module, kLargeCharge, At(0, -0.5, a) * AngleAxisd(90 * kDegree, Vector3d::UnitY()));
  Alone scene(module);
  scene.dut.Push(1, {0, kLargeCharge.mass * 2.5, 0}, {0, -0.5, a});
  ASSERT_TRUE(scene.RunToRest(60));
  EXPECT_GT(TiltOf(scene.state(0)) + scene.state(0).X_MO.translation().y(), 0.05);
}

TEST(RigidBodies, WhatLeansOnARemovedThingFalls) {
  ModuleModel module = GroundOf(20);
  AddMovable(module, Shape::Box({0.4, 0.4, 0.4}), 5, At(0, 0, 0.2));
  AddCharge(module, kMiddleCharge, At(0, 0, 0.4 + kMiddleCharge.height / 2));
  Alone scene(module);
  scene.Run(1);
  ASSERT_FALSE(scene.AnyMoves());
  scene.dut.Remove(0);
  EXPECT_TRUE(scene.state(0).is_gone);
  ASSERT_TRUE(scene.RunToRest(10));
  EXPECT_NEAR(scene.state(1).X_MO.translation().z(), kMiddleCharge.height / 2, 0.5e-3);
}

TEST(RigidBodies, ThingOfSeveralPartsStandsOnItsBaseAndRightsItself) {
  ModuleModel module = GroundOf(20);
  AddMovable(module, Shape::Box({0.3, 0.3, 0.04}), 2,
             At(0, 0, 0) * AngleAxisd(0.3, Vector3d::UnitX()));
  MovableObject& cone = module.movables[0];
  cone.parts[0].X_OS = At(0, 0, 0.02);
  cone.parts.push_back({.shape = Shape::Cylinder(0.08, 0.5), .X_OS = At(0, 0, 0.29)});
  cone.p_OC = {0, 0, 0.12};
  cone.X_MO.translation().z() = 0.15 * std::sin(0.3);
  Alone scene(module);
  scene.Wake();
  ASSERT_TRUE(scene.RunToRest(10));
  EXPECT_LT(TiltOf(scene.state()), 0.1 * kDegree);
  EXPECT_NEAR(scene.state().X_MO.translation().z(), 0, 0.3e-3) << "its origin is at its foot";
}

}  // namespace
}  // namespace eod::sim
