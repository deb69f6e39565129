// What the bomb module holds, measured by casting segments.
#include <cmath>

#include "tests/unit/sim/training_ground.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

const BuiltModule& Bomb() {
  static const BuiltModule module(3);
  return module;
}

const MovableObject& Movable(const std::string& name) {
  for (const MovableObject& movable : Bomb().model().movables) {
    if (movable.name == name) return movable;
  }
  throw std::runtime_error(name);
}

const VesselSpec& Vessel(const std::string& name) {
  for (const VesselSpec& vessel : Bomb().model().vessels) {
    if (vessel.name == name) return vessel;
  }
  throw std::runtime_error(name);
}

TEST(BombModule, LiesWhereTheMapSays) {
  const ModuleModel& module = Bomb().model();
  EXPECT_EQ(module.name, "bomb");
  EXPECT_EQ(module.class_bit, kModuleBomb);
  EXPECT_EQ(module.p_WM, Vector3d(0, 0, 0));
  EXPECT_EQ(module.half_size, Eigen::Vector2d(60, 60));
  EXPECT_EQ(module.movables.size(), 8u);
  EXPECT_EQ(module.vessels.size(), 2u);
}

struct Charge {
  const char* name;
  double radius, length, mass, x, y, support;
};

class TrainingCharge : public ::testing::TestWithParam<Charge> {};

TEST_P(TrainingCharge, IsTheCylinderOfTheTableAndStandsOnItsSupport) {
  const Charge& charge = GetParam();
  const MovableObject& dut = Movable(charge.name);
  ASSERT_TRUE(dut.explosive.has_value());
  EXPECT_EQ(dut.explosive->radius, charge.radius);
  EXPECT_EQ(dut.explosive->half_height, charge.length / 2);
  EXPECT_EQ(dut.mass, charge.mass);
  EXPECT_TRUE(dut.p_OC.isZero());
  EXPECT_EQ(dut.object_class, kModuleBomb | kBumpProxy | kBombObject);
  EXPECT_TRUE(dut.X_MO.linear().isIdentity(1e-12));
  EXPECT_NEAR(
      (dut.X_MO.translation() - Vector3d(charge.x, charge.y, charge.support + charge.length / 2))
          .norm(),
      0, 1e-12);
  // Its support, seen from beside and below: nothing between them, nothing in it.
  const double below = charge.support + 0.05;
  const auto met =
      Bomb().Look({charge.x + charge.radius + 0.01, charge.y, below}, -Vector3d::UnitZ());
  EXPECT_NEAR(met.range, 0.05, 1e-9) << met.object;
}

INSTANTIATE_TEST_SUITE_P(Charges, TrainingCharge,
                         ::testing::Values(Charge{"charge_s", 0.030, 0.160, 1, -4, 6, 0.75},
                                           Charge{"charge_m", 0.060, 0.240, 3, 0, 6, 0},
                                           Charge{"charge_l", 0.075, 0.300, 6, 4, 6, 0},
                                           Charge{"charge_h", 0.075, 0.300, 12, 8, 6, 0}));

TEST(BombModule, BenchLeavesRoomBelow) {
  for (const double x : {3.3, 4.5, 4.7}) {
    const auto met = Bomb().Look({x, 6, 0.01}, Vector3d::UnitZ());
    EXPECT_EQ(met.object, "bench");
    EXPECT_NEAR(met.range, 0.64, 1e-9);
  }
  // Between its legs, from the south to the charge: wider than the robot.
  for (const double x : {4 - 0.70, 4 + 0.70}) {
    EXPECT_LT(Bomb().Look({x, 2, 0.3}, Vector3d::UnitY()).range, 0) << x;
  }
  EXPECT_EQ(Bomb().Look({4, 2, 0.15}, Vector3d::UnitY()).object, "charge_l");
}

TEST(BombModule, RobotReachesEveryChargeStraightFromTheCrossLane) {
  for (const auto& [x, object] : {std::pair(-4, "table"), {0, "charge_m"}, {8, "charge_h"}}) {
    for (const double side : {-0.45, 0.45}) {
      for (const double z : {0.05, 0.3, 0.9, 1.4}) {
        const double range = Bomb().Look({x + side, 2, z}, Vector3d::UnitY()).range;
        EXPECT_TRUE(range < 0 || range > 3.5) << object << " " << z;
      }
    }
    EXPECT_EQ(Bomb().Look({1.0 * x, 2, x < 0 ? 0.73 : 0.1}, Vector3d::UnitY()).object, object);
  }
}

TEST(BombModule, DrumIsOpenAboveAndHoldsANet) {
  const VesselSpec& can = Vessel("can");
  EXPECT_EQ(can.inner_radius, 0.25);
  EXPECT_EQ(can.rim_z, 0.85);
  EXPECT_EQ(can.net_z, 0.50);
  const Vector3d axis(0, 18, 0);
  EXPECT_TRUE(can.X_MV.translation().isApprox(axis));
  const auto net = Bomb().Look(axis + Vector3d(0.1, -0.1, 2), -Vector3d::UnitZ());
  EXPECT_NEAR(net.point.z(), can.net_z, 1e-9);
  EXPECT_EQ(net.object, "can");
  EXPECT_EQ(net.object_class, kModuleBomb | kContainmentVessel | kClampProxy | kBumpProxy);
  // Wall and rim. The wall's flat sides touch the inner radius from outside.
  for (double angle = 0; angle < 6.2; angle += 0.37) {
    const Vector3d outwards(std::cos(angle), std::sin(angle), 0);
    const auto wall = Bomb().Look(axis + Vector3d(0, 0, 0.7), outwards);
    EXPECT_GE(wall.range, can.inner_radius - 1e-4);
    EXPECT_LE(wall.range, can.inner_radius / std::cos(std::acos(-1) / 24) + 1e-4);
    const auto rim = Bomb().Look(axis + 0.29 * outwards + Vector3d(0, 0, 2), -Vector3d::UnitZ());
    EXPECT_NEAR(rim.point.z(), can.rim_z, 1e-9);
  }
  EXPECT_NEAR((Movable("charge_m").X_MO.translation() - axis).head<2>().norm(), 12, 1e-12);
}

TEST(BombModule, ChamberIsOpenTowardsSouthWithItsTrayAtTheDoor) {
  const VesselSpec& chamber = Vessel("chamber");
  EXPECT_EQ(chamber.inner_radius, 0);
  EXPECT_EQ(chamber.half_size.head<2>(), Eigen::Vector2d(0.25, 0.40));
  EXPECT_EQ(chamber.net_z, 0.60);
  const Vector3d origin = chamber.X_MV.translation();
  EXPECT_TRUE(origin.isApprox(Vector3d(12, 18, 0)));
  // A hand goes in at the height of charge S's middle and meets the wall at the back.
  for (const double x : {-0.25, 0.0, 0.25}) {
    const auto met = Bomb().Look(origin + Vector3d(x, -1.5, 0.87), Vector3d::UnitY());
    EXPECT_EQ(met.object, "chamber");
    EXPECT_GT(met.range, 1.5 + 0.4);
  }
  // Wherever a charge counts as inside, the tray is below, and what is above is the roof.
  for (const double x : {-0.24, 0.0, 0.24}) {
    for (const double y : {-0.30, 0.0, 0.25}) {
      const Vector3d inside = origin + Vector3d(x, y, 0.9);
      EXPECT_NEAR(Bomb().Look(inside, -Vector3d::UnitZ()).point.z(), chamber.net_z, 1e-9);
      const auto roof = Bomb().Look(inside, Vector3d::UnitZ());
      EXPECT_EQ(roof.object, "chamber");
      EXPECT_LE(roof.point.z(), chamber.rim_z + 0.01);
    }
  }
}

TEST(BombModule, PlatformBinShelfAndNicheStandInTheirLanes) {
  EXPECT_NEAR(Bomb().HeightAt(-8, 7), 0.30, 1e-9);
  EXPECT_EQ(Bomb().Look({-12, 3, 0.3}, Vector3d::UnitY()).object, "bin");
  EXPECT_NEAR(Bomb().HeightAt(-16, 6.2), 1.25, 1e-9);
  // The niche: 0.5 wide, 0.5 high, 0.4 deep.
  const Vector3d inside(-20, 6.2, 0.75);
  EXPECT_NEAR(Bomb().Look(inside, Vector3d::UnitX()).range, 0.25, 1e-9);
  EXPECT_NEAR(Bomb().Look(inside, -Vector3d::UnitX()).range, 0.25, 1e-9);
  EXPECT_NEAR(Bomb().Look(inside, Vector3d::UnitZ()).range, 0.25, 1e-9);
  EXPECT_NEAR(Bomb().Look(inside, Vector3d::UnitY()).range, 0.2, 1e-9);
}

TEST(BombModule, LooseThingsStandOnTheGround) {
  for (const auto& [name, x, y] : {std::tuple("carton_1", 16, 6),
                                   {"carton_2", 16, 9},
                                   {"loose_cone_1", 20, 5},
                                   {"loose_cone_2", 20, 8}}) {
    const MovableObject& dut = Movable(name);
    EXPECT_FALSE(dut.explosive.has_value());
    EXPECT_EQ(dut.object_class, kModuleBomb | kBumpProxy | kMovableObject);
    EXPECT_EQ(Bomb().Look({1.0 * x, 1.0 * y, 2}, -Vector3d::UnitZ()).object, name);
    EXPECT_EQ(Bomb().Look({1.0 * x, y - 1.0, 0.01}, Vector3d::UnitY()).object, name);
    EXPECT_EQ(dut.X_MO.translation().head<2>(), Eigen::Vector2d(x, y));
  }
}

}  // namespace
}  // namespace eod::sim
