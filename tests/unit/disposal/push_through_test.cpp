#include "sim/disposal/push_through.h"

#include <gtest/gtest.h>

#include "tests/unit/disposal/bench.h"

namespace eod::sim {
namespace {

using Eigen::Isometry3d;

constexpr int kSecond = 250;  // steps

/// A charge a centimetre before the left finger's tip: l1 stops the drive.
void PlaceAhead(Bench& bench) {
  bench.Open(0.10);
  bench.PlaceInHand(-0.10, 0.08 + 0.06 + 0.004);
}

TEST(PushThrough, AfterASecondOfPushingTheRobotCreepsOnIntoTheCharge) {
  Bench bench;
  PlaceAhead(bench);
  bench.Step(DemandFor({kDriveForward}));
  ASSERT_TRUE(Contains(bench.response.blocked, kDriveForward));
  EXPECT_TRUE(bench.dut.status().touched);
  const double y = bench.state.position.y();
  bench.Step(DemandFor({kDriveForward}), kSecond);
  EXPECT_EQ(bench.state.position.y(), y);
  bench.Step(DemandFor({kDriveForward}));
  // Creep is 0.10 m/s.
  EXPECT_NEAR(bench.state.position.y() - y, 0.10 * kStep, 1e-12);
  EXPECT_TRUE(Contains(bench.response.blocked, kDriveForward));  // it is told all the while
}

TEST(PushThrough, ACreepingRobotIsNotMadeFasterAndAnArmTakesItsShare) {
  Bench bench;
  EXPECT_EQ(PushThrough(bench.robot, TheRules().charge).RateOf(kDriveForward, 0), 1);
  EXPECT_NEAR(PushThrough(bench.robot, TheRules().charge).RateOf(kDriveForward, 2), 0.10 / 0.67,
              1e-12);
  EXPECT_EQ(PushThrough(bench.robot, TheRules().charge).RateOf(kBigArmDown, 1),
            TheRules().charge.push_share);
}

TEST(PushThrough, LettingGoStartsAnew) {
  Bench bench;
  PlaceAhead(bench);
  bench.Step(DemandFor({kDriveForward}), kSecond);
  bench.Step({});
  const double y = bench.state.position.y();
  bench.Step(DemandFor({kDriveForward}), kSecond);
  EXPECT_EQ(bench.state.position.y(), y);
}

TEST(PushThrough, AWallBesideTheChargeKeepsTheRobotWhereItIs) {
  Bench bench;
  PlaceAhead(bench);
  bench.Step(DemandFor({kDriveForward}));
  bench.world.AddBox(
      "wall", kModuleBomb | kBumpProxy,
      bench.X_MG() * Eigen::Translation3d(0.10, 0.31 + 0.06, 0) * Isometry3d::Identity(),
      {0.1, 0.1, 0.1});
  bench.world.AddPlane("board", kModuleBomb | kBumpProxy,
                       {0, bench.X_MG().translation().y() + 0.31 + 0.004, 0}, {0, -1, 0});
  const double y = bench.state.position.y();
  bench.Step(DemandFor({kDriveForward}), 3 * kSecond);
  EXPECT_EQ(bench.state.position.y(), y);
}

TEST(PushThrough, AThingPushedSkinOnSkinStaysInContactWithTheLineThatStartsThere) {
  Bench bench;
  bench.Open(0.10);
  // The right tip a millimetre inside: its line l4 leaves the charge 119 mm on, and its D0 is 20.
  bench.PlaceInHand(0.10, 0.08 + 0.06 - 0.001);
  bench.Step(DemandFor({kDriveForward}));
  EXPECT_NEAR(bench.Range("l4"), 0.119, 1e-6);
  EXPECT_TRUE(Contains(bench.response.blocked, kDriveForward));
  EXPECT_TRUE(bench.dut.status().touched);
  bench.Step(DemandFor({kDriveReverse}));
  EXPECT_FALSE(Contains(bench.response.blocked, kDriveReverse));
}

TEST(PushThrough, SqueezingIsNoPushing) {
  Bench bench;
  bench.Open(0.0549);
  bench.PlaceInHand(0, 0.027);
  bench.Step(DemandFor({kGripperClose}), kSecond);
  EXPECT_TRUE(Contains(bench.response.blocked, kGripperClose));
  EXPECT_FALSE(Contains(bench.verdict.let_through, kGripperClose));
}

}  // namespace
}  // namespace eod::sim
