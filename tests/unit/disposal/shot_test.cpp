#include "sim/disposal/shot.h"

#include <gtest/gtest.h>

#include "tests/unit/disposal/bench.h"

namespace eod::sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

/// A charge M `away` before the muzzle, beside and above its line.
class Shooting : public ::testing::Test {
 protected:
  std::optional<Shot> At(double away, double beside = 0, double above = 0) {
    bodies_[0].X_MO = Eigen::Translation3d(beside, away + 0.06, above) * Isometry3d::Identity();
    world_.Move(object_, bodies_[0].X_MO);
    const std::vector<int> movables = {-1, 0};
    return ShotFrom(Isometry3d::Identity(), world_, module_, bodies_, movables,
                    TheRules().disrupter, memory_);
  }

  ModuleModel module_ = BombModule({CylinderM()});
  std::vector<BodyState> bodies_{1};
  AnalyticWorld world_;
  int wall_ = world_.AddBox("wall", kModuleBomb | kBumpProxy,
                            Eigen::Translation3d(0, -9, 0) * Isometry3d::Identity(), {1, 0.1, 1});
  int object_ = world_.AddShape("charge", kModuleBomb | kBombObject | kBumpProxy,
                                Isometry3d::Identity(), Shape::Cylinder(0.06, 0.24));
  CastMemory memory_;
};

TEST_F(Shooting, InTheMiddleItDisrupts) {
  const auto shot = At(1.5);
  ASSERT_TRUE(shot);
  EXPECT_EQ(shot->body, 0);
  EXPECT_TRUE(shot->disrupted);
  EXPECT_TRUE(shot->p_M.isApprox(Vector3d(0, 1.5, 0), 1e-9));
  EXPECT_TRUE(shot->impulse_M.isApprox(Vector3d(0, TheRules().disrupter.impulse, 0), 1e-12));
}

TEST_F(Shooting, TooNearTooFarOrOffTheMiddleItSetsOff) {
  // 0.2 .. 3 m, 30 mm beside or above; 35 degrees are 0.57 of the radius.
  EXPECT_FALSE(At(0.19)->disrupted);
  EXPECT_TRUE(At(0.21)->disrupted);
  EXPECT_TRUE(At(2.99)->disrupted);
  EXPECT_FALSE(At(3.01)->disrupted);
  EXPECT_TRUE(At(1, 0.029)->disrupted);
  EXPECT_FALSE(At(1, -0.031)->disrupted);
  EXPECT_TRUE(At(1, 0, 0.029)->disrupted);
  EXPECT_FALSE(At(1, 0, 0.031)->disrupted);
}

TEST_F(Shooting, PastItOrIntoAWallItDoesNothing) {
  EXPECT_FALSE(At(1, 0.061));
  EXPECT_FALSE(At(30.1));
  world_.Move(wall_, Eigen::Translation3d(0, 0.5, 0) * Isometry3d::Identity());
  EXPECT_FALSE(At(1));
}

TEST(Disposal, ABlastBeginsOnWhatLiesBelowTheCharge) {
  const auto crushed_in_the_hand = [](Bench& bench) {
    bench.Open(0.08);
    bench.PlaceInHand(0, 0);
    EXPECT_TRUE(bench.CloseUntilGrasped());
    bench.rolled_over = true;
    bench.Step({});
    EXPECT_EQ(bench.dut.status().detonation, DetonationCause::kCrushed);
    const Eigen::Vector3d along =
        bench.dut.status().detonation_ground - bench.dut.status().detonation_point;
    EXPECT_EQ(along.head<2>().norm(), 0);
    return bench.dut.status().detonation_ground.z();
  };
  Bench on_ground;
  on_ground.world.AddPlane("ground", kModuleBomb | kClampProxy, {0, 0, 0}, {0, 0, 1});
  EXPECT_NEAR(crushed_in_the_hand(on_ground), 0, 1e-9);

  Bench on_table;
  const double top = 0.5;
  on_table.world.AddPlane("ground", kModuleBomb | kClampProxy, {0, 0, 0}, {0, 0, 1});
  on_table.world.AddBox("table", kModuleBomb | kClampProxy,
                        Eigen::Translation3d(0, 1.15, top - 0.02) * Isometry3d::Identity(),
                        {2, 2, 0.04});
  EXPECT_NEAR(crushed_in_the_hand(on_table), top, 1e-9);

  Bench over_nothing;
  const double lowest = crushed_in_the_hand(over_nothing);
  EXPECT_NEAR(lowest, over_nothing.dut.status().detonation_point.z() - 0.12, 1e-9);
}

TEST(Disposal, AShotOfThePanelDisruptsWhatTheBarrelLooksAt) {
  Bench bench;
  const int wrist = FindLink(bench.robot, "wrist");
  const auto place = [&](double beside) {
    bench.bodies[0].X_MO =
        BarrelPose(bench.X_ML[wrist], TheRules().disrupter) * Eigen::Translation3d(beside, 1, 0);
  };
  const auto fire = [&] {
    bench.panel = {.arm_key = 1, .fire_left = 1, .fire_right = 1, .circuit = 1};
    bench.Step({});
    bench.panel.arm_key = 2;
    bench.Step({}, 251);
    bench.panel.nonce_echo = bench.dut.status().fire_nonce;
    bench.panel.fire_left = bench.panel.fire_right = 2;
    bench.Step({}, 75);
    EXPECT_EQ(bench.dut.status().fire, FireState::kReady);
    bench.Step({});
    EXPECT_EQ(bench.dut.status().fire, FireState::kFired);
  };
  place(0);
  fire();
  EXPECT_EQ(bench.dut.status().bomb, BombState::kDisrupted);
  EXPECT_EQ(bench.dut.orders().push, 0);
  EXPECT_EQ(bench.dut.status().detonation, DetonationCause::kNone);

  bench.dut.Reset();
  place(0.04);
  fire();
  EXPECT_EQ(bench.dut.status().detonation, DetonationCause::kShot);
  EXPECT_EQ(bench.dut.orders().remove, 0);
  EXPECT_TRUE(bench.dut.status().robot_destroyed);
  EXPECT_TRUE(bench.dut.Ignores(0));
}

}  // namespace
}  // namespace eod::sim
