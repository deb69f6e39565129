#include "sim/radio/control_link.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/counting_new.h"
#include "tests/unit/sim/radio_scene.h"

namespace eod::sim {
namespace {

using Kind = ControlLinkSpec::Kind;
constexpr double kStep = 0.004;  // [s]
constexpr int kLook = 25;        // steps between two looks: 0.1 s

/// What the link says after the robot has stood at a place for one look.
void Stand(ControlLink& dut, const World& world, const RobotState& state) {
  for (int i = 0; i < kLook; ++i) dut.Advance(world, state, false, false);
}

TEST(RadioQuality, FallsEvenlyWithDistanceAndByAShareForEachWall) {
  ControlLinkSpec spec{.kind = Kind::kRadio, .range = 400, .wall_loss = 0.25};
  EXPECT_EQ(RadioQuality(spec, 0, 0), 1);
  EXPECT_DOUBLE_EQ(RadioQuality(spec, 100, 0), 0.75);
  EXPECT_DOUBLE_EQ(RadioQuality(spec, 100, 1), 0.75 * 0.75);
  EXPECT_DOUBLE_EQ(RadioQuality(spec, 200, 2), 0.5 * 0.75 * 0.75);
  EXPECT_EQ(RadioQuality(spec, 400, 0), 0);
  EXPECT_EQ(RadioQuality(spec, 900, 0), 0);
}

TEST(RadioQuality, MessagesDropBelowTheLimitAndAllOfThemAtNothing) {
  EXPECT_EQ(DropChance(kLinkRules, 1), 0);
  EXPECT_EQ(DropChance(kLinkRules, 0.2), 0);
  EXPECT_DOUBLE_EQ(DropChance(kLinkRules, 0.15), 0.25);
  EXPECT_DOUBLE_EQ(DropChance(kLinkRules, 0.05), 0.75);
  EXPECT_EQ(DropChance(kLinkRules, 0), 1);
}

TEST(ControlLink, RadioCountsTheWallsBetweenTheAntennas) {
  ModuleModel module = Ground();
  AddWallAt(module, 0, 10, 8);
  AddWallAt(module, 0, 20, 8);
  const BuiltWorld world(module);
  const ControlLinkSpec spec{.kind = Kind::kRadio, .range = 100, .wall_loss = 0.2};
  ControlLink dut(spec, kLinkRules, kStep);
  dut.Reset(world, kModuleFlat, StandingAt(0, 0), true);
  for (const int walls : {0, 1, 2}) {
    const double y = 5 + 10 * walls;
    Stand(dut, world, StandingAt(0, y));
    EXPECT_EQ(dut.walls(), walls);
    const double distance = std::hypot(y, kLinkRules.base_antenna - kLinkRules.robot_antenna);
    EXPECT_DOUBLE_EQ(dut.distance(), distance);
    EXPECT_DOUBLE_EQ(dut.quality(), (1 - distance / 100) * std::pow(0.8, walls));
  }
  // Round the walls: the line from the base passes x = 10 at y = 10 and x = 20 at y = 20.
  Stand(dut, world, StandingAt(25, 25));
  EXPECT_EQ(dut.walls(), 0);
}

TEST(ControlLink, LooksAtThePeriodOfTheRulesAlone) {
  const BuiltWorld world(Ground());
  ControlLink dut({.kind = Kind::kRadio}, kLinkRules, kStep);
  dut.Reset(world, kModuleFlat, StandingAt(0, 0), true);
  const uint64_t before = dut.work().segments;
  for (int i = 0; i < 250; ++i) dut.Advance(world, StandingAt(0, 0.001 * i), false, false);
  EXPECT_EQ(dut.work().segments - before, 10u);  // 1 s
}

TEST(ControlLink, IdealLinkNeverLooksNorLoses) {
  const BuiltWorld world(Ground());
  ControlLink dut({}, kLinkRules, kStep);
  dut.Reset(world, kModuleFlat, StandingAt(0, 0), true);
  Stand(dut, world, StandingAt(0, 90));
  EXPECT_EQ(dut.work().segments, 0u);
  EXPECT_EQ(dut.quality(), 1);
  EXPECT_EQ(dut.drop_chance(), 0);
}

TEST(ControlLink, SilenceTakesAllQuality) {
  const BuiltWorld world(Ground());
  ControlLink dut({}, kLinkRules, kStep);
  dut.Reset(world, kModuleFlat, StandingAt(0, 0), true);
  dut.Advance(world, StandingAt(0, 0), true, false);
  EXPECT_EQ(dut.drop_chance(), 1);
  dut.Advance(world, StandingAt(0, 0), false, false);
  EXPECT_EQ(dut.drop_chance(), 0);
}

TEST(ControlLink, CableForbidsTheDriveThatTakesTheRobotFartherOut) {
  const BuiltWorld world(Ground());
  ControlLink dut({.kind = Kind::kCable, .cable_length = 20}, kLinkRules, kStep);
  dut.Reset(world, kModuleFlat, StandingAt(0, 0), true);
  dut.Advance(world, StandingAt(0, 19.99), false, false);
  EXPECT_EQ(dut.ForbiddenMotions(StandingAt(0, 19.99)), 0u);
  const RobotState out = StandingAt(0, 20), turned_back = StandingAt(0, 20, 3.0);
  dut.Advance(world, out, false, false);
  EXPECT_DOUBLE_EQ(dut.cable().paid_out(), 20);
  EXPECT_EQ(dut.ForbiddenMotions(out), SetOf(kDriveForward));
  EXPECT_EQ(dut.ForbiddenMotions(turned_back), SetOf(kDriveReverse));
}

TEST(Cable, LiesRoundTheCornersThatTheRobotDroveRound) {
  ModuleModel module = Ground();
  AddWallAt(module, -9, 5, 22);  // to x = 2
  const BuiltWorld world(module);
  SightLine sight;
  sight.SetModule(kModuleFlat);
  Cable dut(100);
  const double z = kLinkRules.cable_height;
  dut.Reset({0, 0, z}, {4.5, 0, z});
  constexpr double kStride = 0.05;
  const auto drive = [&](Eigen::Vector3d from, Eigen::Vector3d to) {
    const int steps = static_cast<int>(std::lround((to - from).norm() / kStride));
    for (int i = 1; i <= steps; ++i) {
      dut.Follow(from + (to - from) * i / steps);
      dut.FindCorners(world, sight);
    }
  };
  drive({4.5, 0, z}, {4.5, 10, z});
  EXPECT_EQ(dut.corners(), 0);
  EXPECT_NEAR(dut.paid_out(), std::hypot(4.5, 10), 1e-9);
  // Going left, the fixed end is hidden once the line to it meets the wall's end: at y = 4.9 of the
  // wall's near face x < 2, that is for a robot at y = 10 left of 2 * 10 / 4.9.
  drive({4.5, 10, z}, {0, 10, z});
  const double corner = 2 * 10 / 4.9;
  EXPECT_EQ(dut.corners(), 1);
  EXPECT_NEAR(dut.paid_out(), std::hypot(corner, 10) + corner, 0.2);
  EXPECT_LT(dut.Outwards().x(), -0.99);
  drive({0, 10, z}, {4.5, 10, z});
  EXPECT_EQ(dut.corners(), 0);
  EXPECT_NEAR(dut.paid_out(), std::hypot(4.5, 10), 1e-9);
}

TEST(Cable, SnaggedReelHoldsWhatIsOutUntilItIsFree) {
  Cable dut(100);
  dut.Reset({0, 0, 0}, {0, 0, 0});
  dut.Follow({0, 30, 0});
  EXPECT_FALSE(dut.is_taut());
  dut.SetSnagged(true);
  EXPECT_TRUE(dut.is_taut());
  dut.Follow({0, 29.9, 0});
  EXPECT_FALSE(dut.is_taut());
  dut.Follow({0, 30, 0});
  EXPECT_TRUE(dut.is_taut());
  dut.SetSnagged(false);
  EXPECT_FALSE(dut.is_taut());
}

TEST(ControlLink, StepsAllocateNothing) {
  ModuleModel module = Ground();
  AddWallAt(module, 0, 10, 8);
  const BuiltWorld world(module);
  for (const Kind kind : {Kind::kRadio, Kind::kCable}) {
    ControlLink dut({.kind = kind}, kLinkRules, kStep);
    dut.Reset(world, kModuleFlat, StandingAt(0, 0), true);
    const long before = AllocationCount();
    for (int i = 0; i < 5000; ++i) {
      dut.Advance(world, StandingAt(6 * std::sin(i * 1e-3), 0.005 * i), false, false);
    }
    EXPECT_EQ(AllocationCount() - before, 0);
  }
}

}  // namespace
}  // namespace eod::sim
