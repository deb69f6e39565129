#include "sim/disposal/held_probe.h"

#include <gtest/gtest.h>

#include "tests/unit/disposal/bench.h"

namespace eod::sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kSkin = 0.005;
constexpr uint32_t kHeldBit = 1u << static_cast<int>(Part::kHeldBomb);

/// Holds a charge M, upright, with nothing else in the world.
std::unique_ptr<Bench> Holding() {
  auto bench = std::make_unique<Bench>();
  bench->Open(0.065);
  bench->PlaceInHand(0, 0);
  EXPECT_TRUE(bench->CloseUntilGrasped());
  return bench;
}

double Bottom(const Bench& bench) {
  return LowestPoint(*bench.module.movables[0].explosive, bench.bodies[0].X_MO);
}

TEST(HeldProbe, SeesNothingUntilAChargeIsHeldAndNothingAfterwards) {
  Bench bench;
  bench.Look(DemandFor({kDriveForward}));
  const size_t without = bench.isectors.segments().size();
  const auto holding = Holding();
  holding->Look(DemandFor({kDriveForward}));
  EXPECT_EQ(holding->isectors.segments().size(), without + 30);
  holding->Step(DemandFor({kGripperOpen}), 40);
  holding->Look(DemandFor({kDriveForward}));
  EXPECT_EQ(holding->isectors.segments().size(), without);
}

TEST(HeldProbe, LinesStartInsideAndReachTheirSkinBeyondTheSurface) {
  RobotModel robot = TheSharpRobot();
  const int index = AppendHeldProbe(robot);
  const ExplosiveSpec charge{0.06, 0.12};
  const Isometry3d X_GO(Eigen::Translation3d(0.01, 0.23, -0.02));
  ShapeHeldProbe(charge, X_GO, -Vector3d::UnitZ(), TheRules().charge, robot.isectors[index]);
  const Shape shape = Shape::Cylinder(charge.radius, 2 * charge.half_height);
  for (const SegmentSpec& segment : robot.isectors[index].segments) {
    const Crossings crossings =
        shape.Cross(segment.start - X_GO.translation(), segment.direction, segment.length);
    // Those down the very edge may graze the mantle; they leave at the end all the same.
    ASSERT_GE(crossings.count, 1u) << segment.name;
    EXPECT_NEAR(crossings.list[crossings.count - 1].range, segment.d0 - kSkin, 1e-6)
        << segment.name;
  }
}

TEST(HeldProbe, AnOverturnedChargeHasItsLowerEndAtTheOtherSide) {
  RobotModel robot = TheSharpRobot();
  const int index = AppendHeldProbe(robot);
  Isometry3d upside_down = Isometry3d::Identity();
  upside_down.rotate(Eigen::AngleAxisd(std::numbers::pi, Vector3d::UnitX()));
  for (const Isometry3d& X_GO : {Isometry3d(Isometry3d::Identity()), upside_down}) {
    ShapeHeldProbe({0.06, 0.12}, X_GO, -Vector3d::UnitZ(), TheRules().charge,
                   robot.isectors[index]);
    int down = 0;
    for (const SegmentSpec& segment : robot.isectors[index].segments) {
      if (segment.direction.z() < -0.9) ++down;
    }
    EXPECT_EQ(down, 13);
  }
}

TEST(HeldProbe, LoweredOntoTheGroundItStopsByItsSkinAndMayBeLifted) {
  const auto bench = Holding();
  const double ground = Bottom(*bench) - 0.05;
  bench->world.AddPlane("ground", kModuleBomb | kBumpProxy | kClampProxy, {0, 0, ground},
                        Vector3d::UnitZ());
  bench->Step(DemandFor({kBigArmDown}), 500);
  EXPECT_TRUE(Contains(bench->response.blocked, kBigArmDown));
  EXPECT_EQ(bench->response.contact_parts, kHeldBit);
  // 10 deg/s at 1.3 m of reach: a millimetre a step at most.
  EXPECT_LE(Bottom(*bench) - ground, kSkin + 1e-9);
  EXPECT_GT(Bottom(*bench) - ground, kSkin - 0.001);
  const double before = Bottom(*bench);
  bench->Step(DemandFor({kBigArmUp}), 20);
  EXPECT_EQ(bench->response.blocked, 0u);
  EXPECT_GT(Bottom(*bench), before);
}

TEST(HeldProbe, WhatItWasTakenFromDoesNotKeepIt) {
  Bench bench;
  bench.Open(0.065);
  bench.PlaceInHand(0, 0);
  bench.world.AddPlane("table", kModuleBomb | kBumpProxy, {0, 0, Bottom(bench)}, Vector3d::UnitZ());
  ASSERT_TRUE(bench.CloseUntilGrasped());
  bench.Step(DemandFor({kBigArmUp}), 50);
  EXPECT_EQ(bench.response.blocked, 0u);
  EXPECT_GT(bench.bodies[0].X_MO.translation().z(), bench.X_MG().translation().z() - 0.05);
}

/// A rim of a vessel before the charge, below the fingers, across the robot's way, 50 mm thick.
void AddRim(Bench& bench, double gap) {
  const Vector3d p_M = bench.bodies[0].X_MO.translation();
  bench.world.AddBox(
      "can", kModuleBomb | kContainmentVessel | kBumpProxy,
      Eigen::Translation3d(p_M.x(), p_M.y() + 0.06 + gap + 0.025, p_M.z() - 0.06 - 0.5) *
          Isometry3d::Identity(),
      {2, 0.05, 1});
}

TEST(HeldProbe, AgainstARimFasterThanTwentyCentimetresASecondItGoesOff) {
  const auto bench = Holding();
  AddRim(*bench, 0.05);
  bench->Step(DemandFor({kDriveForward}, 1, 1), 100);  // 0.30 m/s
  EXPECT_EQ(bench->dut.status().detonation, DetonationCause::kRimStrike);
  EXPECT_TRUE(bench->dut.status().robot_destroyed);
  EXPECT_EQ(bench->removed, 0);
}

TEST(HeldProbe, AgainstARimSlowlyItStops) {
  const auto bench = Holding();
  AddRim(*bench, 0.05);
  bench->Step(DemandFor({kDriveForward}, 0.6, 1), 200);  // 0.18 m/s
  EXPECT_EQ(bench->dut.status().detonation, DetonationCause::kNone);
  EXPECT_TRUE(Contains(bench->response.blocked, kDriveForward));
  EXPECT_EQ(bench->response.contact_parts, kHeldBit);
  bench->Step(DemandFor({kDriveReverse}), 20);
  EXPECT_EQ(bench->response.blocked & SetOf(kDriveReverse), 0u);
}

TEST(HeldProbe, ItsEdgeFindsARimBelowWhereverThatRuns) {
  // A wall 40 mm thick, its top 3 mm below the charge, across it at any angle and place.
  for (double turn = 0; turn < std::numbers::pi; turn += std::numbers::pi / 24) {
    for (double off = -0.05; off <= 0.05; off += 0.01) {
      RobotModel robot = TheSharpRobot();
      const int index = AppendHeldProbe(robot);
      ShapeHeldProbe({0.06, 0.12}, Isometry3d::Identity(), -Vector3d::UnitZ(), TheRules().charge,
                     robot.isectors[index]);
      Isometry3d X_CW = Isometry3d::Identity();
      X_CW.rotate(Eigen::AngleAxisd(turn, Vector3d::UnitZ()));
      X_CW.translate(Vector3d(off, 0, -0.12 - 0.003 - 0.5));
      const Shape rim = Shape::Box({0.04, 2, 1});
      bool found = false;
      for (const SegmentSpec& segment : robot.isectors[index].segments) {
        const Isometry3d X_WC = X_CW.inverse();
        const Crossings crossings =
            rim.Cross(X_WC * segment.start, X_WC.linear() * segment.direction, segment.length);
        found = found || (segment.direction.z() < -0.5 && crossings.count > 0 &&
                          crossings.list[0].range < segment.d0);
      }
      EXPECT_TRUE(found) << turn / kDegree << " " << off;
    }
  }
}

}  // namespace
}  // namespace eod::sim
