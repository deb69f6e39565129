// What the outdoor module holds, measured by casting segments.
#include <cmath>
#include <numbers>

#include "tests/unit/sim/training_ground.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kKerb = 3.5, kFronts = 6.0, kCourse = 96;

const BuiltModule& Outdoor() {
  static const BuiltModule module(4);
  return module;
}

const MovableObject& Movable(const std::string& name) {
  for (const MovableObject& movable : Outdoor().model().movables) {
    if (movable.name == name) return movable;
  }
  throw std::runtime_error(name);
}

/// Nothing stands in the way of a robot that drives `metres` from (x, y).
void ExpectClearWay(double x, double y, const Vector3d& way, double metres) {
  const Vector3d beside(-way.y(), way.x(), 0);
  for (const double side : {-0.45, 0.0, 0.45}) {
    for (const double z : {0.05, 0.3, 0.9, 1.3}) {
      for (double from = 0; from < metres; from += 9) {
        const double length = std::min(9.0, metres - from);
        const auto met =
            Outdoor().Look(Vector3d(x, y, z) + from * way + side * beside, way, kBumpProxy);
        EXPECT_TRUE(met.range < 0 || met.range > length)
            << met.object << " " << met.point.transpose();
      }
    }
  }
}

TEST(OutdoorModule, LiesWhereTheMapSays) {
  const ModuleModel& module = Outdoor().model();
  EXPECT_EQ(module.name, "outdoor");
  EXPECT_EQ(module.class_bit, kModuleOutdoor);
  EXPECT_EQ(module.p_WM, Vector3d(-900, -900, 0));
  EXPECT_EQ(module.half_size, Eigen::Vector2d(250, 250));
  EXPECT_EQ(module.start_attitude, Attitude{});
  EXPECT_GE(module.objects.size(), 26u);
  EXPECT_EQ(module.vessels.size(), 1u);
}

TEST(OutdoorModule, StreetOfThreeHundredMetresIsLevelAndClearFromTheStart) {
  for (double y = -59; y < 240; y += 1.7) {
    for (const double x : {-3.2, -1.0, 0.5, 3.2}) {
      EXPECT_EQ(Outdoor().Look({x, y, 0.02}, -Vector3d::UnitZ(), kClampProxy).range, 0.02);
    }
  }
  ExpectClearWay(0.2, -50, Vector3d::UnitY(), 290);
  // On level ground the robot's stance needs no casts.
  for (double y = -40; y < 230; y += 9) {
    const Eigen::AlignedBox3d here(Vector3d(-0.6, y - 0.8, -0.3), Vector3d(0.6, y + 0.8, 0.4));
    EXPECT_EQ(Outdoor().LevelGroundIn(here), 0.0) << y;
  }
}

TEST(OutdoorModule, KerbsOfFifteenCentimetresRunAlongBothSides) {
  for (const double y : {-50.0, -10.0, 12.0, 55.0, 70.0, 100.0, 150.0, 230.0}) {
    for (const double side : {-1.0, 1.0}) {
      const Vector3d outwards = side * Vector3d::UnitX();
      const auto met = Outdoor().Look({side * 2, y, 0.149}, outwards);
      EXPECT_EQ(met.object, "pavements");
      EXPECT_NEAR(met.point.x(), side * kKerb, 1e-9);
      EXPECT_NE(Outdoor().Look({side * 2, y, 0.151}, outwards).object, "pavements");
      EXPECT_NEAR(Outdoor().HeightAt(side * (kKerb + 0.5), y, kClampProxy), 0.15, 1e-9);
      EXPECT_NEAR(Outdoor().HeightAt(side * (kKerb - 0.1), y, kClampProxy), 0.075, 1e-9);
      EXPECT_EQ(Outdoor().HeightAt(side * (kKerb - 0.1), y), 0);
    }
  }
}

TEST(OutdoorModule, KerbIsDroppedAtTheZebraAndMissingAtTheSquareAndTheLane) {
  for (const double side : {-1.0, 1.0}) {
    EXPECT_NEAR(Outdoor().HeightAt(side * (kKerb + 0.6), 62), 0.075, 1e-9);
    EXPECT_NEAR(Outdoor().HeightAt(side * (kKerb + 1.3), 62), 0.15, 1e-9);
  }
  for (double x = -19; x < -3; x += 1.3) EXPECT_EQ(Outdoor().HeightAt(x, 35), 0) << x;
  for (double x = 3; x < 71; x += 1.3) EXPECT_EQ(Outdoor().HeightAt(x, 87), 0) << x;
}

TEST(OutdoorModule, HousesStandAlongTheStreet) {
  for (const double y : {-50.0, -10.0, 10.0, 70.0, 120.0, 150.0, 220.0}) {
    const auto met = Outdoor().Look({-4, y, 2}, -Vector3d::UnitX());
    EXPECT_EQ(met.object.substr(0, 7), "houses_") << y;
    EXPECT_NEAR(met.point.x(), -kFronts, 1e-9);
  }
}

TEST(OutdoorModule, ParkedCarHasItsClearanceAndItsBootSill) {
  const double x = 2.45, rear = 150;
  for (const double y : {151.0, 152.15, 153.5}) {
    const auto met = Outdoor().Look({x, y, 0.01}, Vector3d::UnitZ());
    EXPECT_EQ(met.object, "parked_car");
    EXPECT_NEAR(met.point.z(), 0.18, 1e-9);
  }
  EXPECT_NEAR(Outdoor().Look({x, rear + 0.1, 0.01}, Vector3d::UnitZ()).point.z(), 0.30, 1e-9);
  // From behind: below the sill the car, above it the open boot.
  EXPECT_NEAR(Outdoor().Look({x, rear - 2, 0.69}, Vector3d::UnitY()).point.y(), rear, 1e-9);
  const auto boot = Outdoor().Look({x, rear - 2, 0.71}, Vector3d::UnitY());
  EXPECT_NEAR(boot.point.y(), rear + 0.85, 1e-9);
  EXPECT_NEAR(Outdoor().Look({x, rear + 0.5, 1.0}, -Vector3d::UnitZ(), kClampProxy).point.z(), 0.60,
              1e-9);
  EXPECT_NEAR(Outdoor().Look({x, rear + 0.5, 0.8}, Vector3d::UnitX()).range, 0.55, 1e-9);
}

TEST(OutdoorModule, ChargeAtTheCarStandsFreeWhereTheGripperReachesIt) {
  const MovableObject& charge = Movable("charge_car");
  ASSERT_TRUE(charge.explosive.has_value());
  EXPECT_EQ(charge.explosive->radius, 0.060);
  EXPECT_EQ(charge.mass, 3);
  const Vector3d at = charge.X_MO.translation();
  EXPECT_EQ(at.z(), charge.explosive->half_height);
  // Between its axis and what is behind it there is room for a finger's front half.
  const auto behind = Outdoor().Look(at + Vector3d(0, 0.061, 0.0), Vector3d::UnitY());
  EXPECT_TRUE(behind.range < 0 || behind.range > 0.08) << behind.object;
  const auto edge = Outdoor().Look(at + Vector3d(0, 0, 0.25), Vector3d::UnitY());
  EXPECT_EQ(edge.object, "parked_car");
  EXPECT_NEAR(edge.range, 0.15, 1e-9);
  ExpectClearWay(at.x(), at.y() - 8, Vector3d::UnitY(), 7.9);
  EXPECT_EQ(Outdoor().Look(at - Vector3d(0, 3, 0), Vector3d::UnitY()).object, "charge_car");
}

TEST(OutdoorModule, SecondChargeStandsOnATableOfTheMarket) {
  const MovableObject& charge = Movable("charge_bag");
  ASSERT_TRUE(charge.explosive.has_value());
  EXPECT_EQ(charge.explosive->radius, 0.030);
  const Vector3d at = charge.X_MO.translation();
  EXPECT_NEAR(at.z() - charge.explosive->half_height, 0.75, 1e-12);
  const auto table = Outdoor().Look(at + Vector3d(0.04, 0, 0), -Vector3d::UnitZ());
  EXPECT_EQ(table.object, "stall_bread");
  EXPECT_NEAR(table.point.z(), 0.75, 1e-9);
  EXPECT_NEAR(Outdoor().Look(at + Vector3d(2, 0, -0.10), -Vector3d::UnitX()).point.x(),
              at.x() + 0.28, 1e-9);
  for (const double side : {-1.0, 1.0}) {
    const Vector3d beside = side * Vector3d::UnitY();
    const auto goods = Outdoor().Look(at + 0.031 * beside, beside);
    EXPECT_GE(goods.range, 0.41) << goods.object;
  }
  ExpectClearWay(at.x() + 8, at.y(), -Vector3d::UnitX(), 7.0);
}

TEST(OutdoorModule, CanStandsOnLevelAsphaltNearTheCar) {
  const VesselSpec& can = Outdoor().model().vessels.at(0);
  EXPECT_EQ(can.name, "can_outdoor");
  const Vector3d at = can.X_MV.translation();
  const double away = (at - Vector3d(2.45, 152.15, 0)).norm();
  EXPECT_GE(away, 12);
  EXPECT_LE(away, 20);
  EXPECT_NEAR(Outdoor().Look(at + Vector3d(0.1, -0.1, 2), -Vector3d::UnitZ()).point.z(), can.net_z,
              1e-9);
  ExpectClearWay(at.x(), at.y() - 12, Vector3d::UnitY(), 10.9);
  ExpectClearWay(2.45, 147, -Vector3d::UnitX(), 3.5);
}

TEST(OutdoorModule, CoverStandsAHundredMetresFromTheCar) {
  const auto met = Outdoor().Look({-2.6, 47, 0.5}, Vector3d::UnitY());
  EXPECT_EQ(met.object, "cover_wall");
  EXPECT_NEAR(Outdoor().HeightAt(-2.6, 48), 1.6, 1e-9);
  EXPECT_GE((met.point - Vector3d(2.45, 150, 0)).norm(), 100);
}

TEST(OutdoorModule, CourseHasTheSizesOfItsTable) {
  for (double y = kCourse; y < kCourse + 12; y += 0.13) {  // gravel
    EXPECT_LE(Outdoor().HeightAt(22.1, y), 0.06 + 1e-9);
    EXPECT_GE(Outdoor().HeightAt(22.1, y), 0);
  }
  EXPECT_GT(Outdoor().HeightAt(22.1, kCourse + 6), 0.005);
  for (const double shift : {0.0, 0.59}) {  // half ramps
    const double x = shift > 0 ? 28.5 : 27.5;
    for (const uint32_t proxy : {kClampProxy, kBumpProxy}) {
      EXPECT_NEAR(Outdoor().HeightAt(x, kCourse + shift + 0.295, proxy), 0.085, 1e-3);
      EXPECT_NEAR(Outdoor().HeightAt(x, kCourse + shift + 0.589, proxy), 0.17, 1e-3);
      EXPECT_NEAR(Outdoor().HeightAt(x, kCourse + shift + 1.179, proxy), 0.0, 1e-3);
    }
  }
  for (const uint32_t proxy : {kClampProxy, kBumpProxy}) {
    EXPECT_EQ(Outdoor().HeightAt(40, kCourse - 0.001, proxy), 0);
    EXPECT_NEAR(Outdoor().HeightAt(40, kCourse + 0.3, proxy), -0.3, 1e-12);
    EXPECT_EQ(Outdoor().HeightAt(40, kCourse + 0.601, proxy), 0);
    EXPECT_NEAR(Outdoor().HeightAt(46, kCourse + 3, proxy), 0.5, 1e-9);
    EXPECT_NEAR(Outdoor().HeightAt(46, kCourse + 8, proxy), 1.0, 1e-9);
    const double up = 2.0 * std::cos(20 * kDegree);
    EXPECT_NEAR(Outdoor().HeightAt(66, kCourse + up, proxy), 2.0 * std::sin(20 * kDegree), 1e-6);
  }
}

TEST(OutdoorModule, StepfieldStaysBelowThirtyCentimetresAndUnderItsSkin) {
  double highest = 0;
  for (int row = 0; row < 30; ++row) {
    for (int column = 0; column < 12; ++column) {
      const double x = 34 - 0.55 + 0.1 * column, y = kCourse + 0.05 + 0.1 * row;
      const double height = Outdoor().HeightAt(x, y);
      highest = std::max(highest, height);
      EXPECT_NEAR(height / 0.05, std::round(height / 0.05), 1e-9);
      for (const double dx : {-0.04, 0.04}) {
        EXPECT_GE(Outdoor().HeightAt(x + dx, y, kClampProxy) + 1e-9, height);
      }
    }
  }
  EXPECT_NEAR(highest, 0.30, 1e-9);
}

TEST(OutdoorModule, MeadowsRollGentlyAndMeetTheLevelGround) {
  double lowest = 0, highest = 0, steepest = 0;
  for (double x = -159.5; x < -60; x += 1.5) {
    for (double y = -9.5; y < 110; y += 1.5) {
      const auto met = Outdoor().Look({x, y, 5}, -Vector3d::UnitZ(), kClampProxy);
      if (met.object != "relief") continue;  // a tree
      lowest = std::min(lowest, met.point.z());
      highest = std::max(highest, met.point.z());
      steepest = std::max(steepest, std::acos(met.normal.z()));
    }
  }
  EXPECT_GT(highest - lowest, 1.5);
  EXPECT_LT(highest, 4);
  EXPECT_GT(steepest, 8 * kDegree);
  EXPECT_LT(steepest, 25 * kDegree);
  for (double y = -10; y < 110; y += 3.1) {
    EXPECT_NEAR(Outdoor().HeightAt(-60.001, y, kClampProxy), 0, 1e-3) << y;
  }
}

TEST(OutdoorModule, GroundHasNoHoles) {
  for (double x = -249; x < 250; x += 4.37) {
    for (double y = -249; y < 250; y += 3.91) {
      EXPECT_GE(Outdoor().HeightAt(x, y, kClampProxy), -1.5) << x << " " << y;
    }
  }
  for (double x = -25; x < 75; x += 0.71) {
    for (double y = -64; y < 249; y += 1.13) {
      EXPECT_GE(Outdoor().HeightAt(x, y, kClampProxy), -0.3 - 1e-12) << x << " " << y;
    }
  }
}

}  // namespace
}  // namespace eod::sim
