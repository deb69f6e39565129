// The office of the indoor module, measured by casting segments.
#include <cmath>

#include "tests/unit/sim/training_ground.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;
using Met = BuiltModule::Met;

constexpr double kRise = 0.165, kRun = 0.28;
constexpr int kSteps = 9;
constexpr double kStorey = 2 * kSteps * kRise;      // [m] floor to floor
constexpr double kCeiling = kStorey - 0.30;         // [m] the slab is 0.30 thick
constexpr double kTurningRadius = 0.626;            // [m] of the robot's corners and their feelers
constexpr double kWay = 0, kUpperWay = 1.08;        // [m] x that the robot drives along
constexpr double kFoot = 15.2, kLanding = 17.44;    // [m] y of the lower flight's ends
constexpr double kUpperFoot = 17.16, kTop = 14.92;  // [m] y of the upper flight's ends

const BuiltModule& Indoor() {
  static const BuiltModule module(5);
  return module;
}

double Range(const Vector3d& start, const Vector3d& direction) {
  return Indoor().Look(start, direction).range;
}

/// Clear width through `middle`, along `across`.
double Width(const Vector3d& middle, const Vector3d& across) {
  return Range(middle, across) + Range(middle, -across);
}

/// Height of the first ground below (x, y, z).
double GroundBelow(double x, double y, double z, uint32_t proxy = kClampProxy) {
  const Met met = Indoor().Look({x, y, z}, -Vector3d::UnitZ(), proxy);
  return met.range < 0 ? -100 : met.point.z();
}

TEST(IndoorModule, LiesWhereTheMapSays) {
  const ModuleModel& module = Indoor().model();
  EXPECT_EQ(module.name, "indoor");
  EXPECT_EQ(module.class_bit, kModuleIndoor);
  EXPECT_EQ(module.p_WM, Vector3d(1000, -1000, 0));
  EXPECT_EQ(module.half_size, Eigen::Vector2d(30, 20));
  EXPECT_EQ(module.start_attitude, Attitude{});
  EXPECT_GE(module.objects.size(), 18u);
  EXPECT_LE(module.movables.size(), 12u);
}

TEST(IndoorModule, CorridorsAreOnePointTwoMetresWide) {
  for (const double z : {0.1, 0.4, 1.2, 2.2}) {
    EXPECT_NEAR(Width({kWay, 9.3, z}, Vector3d::UnitX()), 1.2, 1e-9) << z;
    EXPECT_NEAR(Width({kUpperWay, 9.1, kStorey + z}, Vector3d::UnitX()), 1.2, 1e-9) << z;
  }
}

struct Door {
  const char* name;
  Vector3d middle;  ///< on the floor, in the middle of the wall
  Vector3d across;
};

class OpenDoor : public ::testing::TestWithParam<Door> {};

TEST_P(OpenDoor, IsNinetyCentimetresWideAndTwoMetresHigh) {
  const auto& [name, middle, across] = GetParam();
  for (const double z : {0.05, 0.5, 1.0, 2.0}) {
    EXPECT_NEAR(Width(middle + z * Vector3d::UnitZ(), across), 0.90, 1e-6) << z;
  }
  EXPECT_NEAR(Range(middle + Vector3d::UnitZ(), Vector3d::UnitZ()), 1.05, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Rooms, OpenDoor,
                         ::testing::Values(Door{"Office101", {-4.275, 4.6, 0}, {0, 1, 0}},
                                           Door{"Meeting", {-0.735, 11.2, 0}, {0, 1, 0}},
                                           Door{"Server", {0.615, 10.8, 0}, {0, 1, 0}},
                                           Door{"Office201", {0.465, 10.9, kStorey}, {0, 1, 0}},
                                           Door{"Office202", {0.465, 6.0, kStorey}, {0, 1, 0}},
                                           Door{"Office203", {1.815, 10.0, kStorey}, {0, 1, 0}}),
                         [](const auto& door) { return std::string(door.param.name); });

TEST(IndoorModule, OneDoorIsHalfOpenAndTwoAreClosed) {
  // The leaf stands across the way at 45 deg, hinged on the north jamb: a robot does not pass.
  const double leaf = Range({kWay, 11.2, 1.0}, -Vector3d::UnitX());
  EXPECT_GT(leaf, 0.81);
  EXPECT_LT(leaf, 1.71);
  EXPECT_LT(Width({-0.735 - 0.5, 11.0, 1.0}, Vector3d::UnitY()), 4);
  EXPECT_NEAR(Range({kWay, 14.0, 1.0}, -Vector3d::UnitX()), 0.735 - 0.02, 1e-6);
  EXPECT_NEAR(Range({kUpperWay, 14.0, 1.0}, Vector3d::UnitX()), 0.735 - 0.02, 1e-6);
}

TEST(IndoorModule, EntranceIsOpenAndTheWayLeadsToTheStairs) {
  EXPECT_NEAR(Width({0, 3.15, 0.5}, Vector3d::UnitX()), 1.8, 1e-6);
  for (const double side : {-0.4, 0.0, 0.4}) {
    for (const double z : {0.03, 0.3, 1.0, 1.4}) {
      const double first = Range({side, 0, z}, Vector3d::UnitY());
      EXPECT_TRUE(first < 0 || first > 9.99) << side << " " << z;
      EXPECT_GT(Range({side, 9, z}, Vector3d::UnitY()), kFoot - 9 - 1e-6) << side << " " << z;
    }
  }
}

TEST(IndoorModule, StoreysAreTwoFlightsApart) {
  for (const auto& [x, y] : {std::pair(-3.0, 10.0), {1.08, 11.0}, {-5.0, 6.0}, {2.4, 4.2}}) {
    for (const uint32_t proxy : {kClampProxy, kBumpProxy}) {
      EXPECT_NEAR(GroundBelow(x, y, kStorey + 0.04, proxy), kStorey, 1e-9) << x << " " << y;
    }
  }
  EXPECT_NEAR(Range({kWay, 12.2, 0.5}, Vector3d::UnitZ()), kCeiling - 0.5, 1e-6);
  // What is above the ground floor's head is no ground to it.
  EXPECT_EQ(GroundBelow(kWay, 12.2, 2.9), 0);
  EXPECT_LT(Indoor().Look({kWay, 12.2, 0.5}, Vector3d::UnitZ(), kClampProxy).range - 2.47, 1e-9);
}

TEST(IndoorModule, FlightsRiseNineTimesSixteenAndAHalfCentimetres) {
  struct Flight {
    double x, foot, base, ahead;
  };
  for (const Flight& flight :
       {Flight{kWay, kFoot, 0, 1}, Flight{kUpperWay, kUpperFoot, kSteps * kRise, -1}}) {
    for (int i = 0; i < kSteps; ++i) {
      const double y = flight.foot + flight.ahead * i * kRun, low = flight.base + i * kRise;
      EXPECT_NEAR(GroundBelow(flight.x, y + flight.ahead * 0.01, low + 1, kBumpProxy), low + kRise,
                  1e-4);
      EXPECT_NEAR(GroundBelow(flight.x, y - flight.ahead * 0.01, low + 1, kBumpProxy), low, 1e-4);
      EXPECT_NEAR(Range({flight.x, y - flight.ahead * 0.1, low + kRise / 2}, {0, flight.ahead, 0}),
                  0.1, 1e-4);
      EXPECT_NEAR(GroundBelow(flight.x, y, low + 1), low + kRise, 1e-3) << "CLAMP";
    }
  }
}

TEST(IndoorModule, LandingHasRoomToTurn) {
  const double z = kSteps * kRise;
  for (const double x : {-0.6, 0.5, 1.7}) {
    EXPECT_NEAR(GroundBelow(x, kLanding + 0.01, z + 1), z, 1e-9);
    EXPECT_NEAR(Range({x, kLanding + 0.1, z + 0.3}, Vector3d::UnitY()), 1.1, 1e-6);
  }
  EXPECT_NEAR(Width({kWay, 18, z + 0.5}, Vector3d::UnitX()), 2.4, 1e-6);
  for (const double x : {kWay, kUpperWay}) {
    for (double angle = 0; angle < 6.28; angle += 0.05) {
      for (const double height : {0.18, 0.25, 0.4}) {
        const Vector3d middle(x, 18.0, z + height);
        const double range = Range(middle, {std::cos(angle), std::sin(angle), 0});
        EXPECT_TRUE(range < 0 || range > kTurningRadius) << x << " " << angle << " " << height;
      }
    }
  }
}

TEST(IndoorModule, RacksLeaveAnAisleOfNinetyCentimetres) {
  for (double x = 1.8; x < 5.3; x += 0.1) {
    for (const double z : {0.1, 1.0, 1.9}) {
      EXPECT_NEAR(Width({x, 10.8, z}, Vector3d::UnitY()), 0.90, 1e-6) << x;
    }
  }
}

TEST(IndoorModule, ChargeStandsUnderADeskWithKneeSpaceInFrontOfTheRobot) {
  const auto& movables = Indoor().model().movables;
  const auto charge = std::find_if(movables.begin(), movables.end(), [](const MovableObject& one) {
    return one.name == "charge_desk";
  });
  ASSERT_NE(charge, movables.end());
  ASSERT_TRUE(charge->explosive.has_value());
  const Vector3d at = charge->X_MO.translation();
  EXPECT_NEAR(at.z(), kStorey + charge->explosive->half_height, 1e-9);
  // Straight ahead of the door, under the desk's top.
  EXPECT_NEAR(at.y(), 10.9, 1e-9);
  EXPECT_NEAR(Range({at.x() + 0.1, at.y(), kStorey + 0.01}, Vector3d::UnitZ()), 0.65 - 0.01, 1e-6);
  EXPECT_GT(Range({0.3, at.y(), kStorey + 0.3}, -Vector3d::UnitX()), 0.3 - at.x());
}

TEST(IndoorModule, RoofCastsAShadowAndFurnitureUnderItNone) {
  for (const WorldObject& object : Indoor().model().objects) {
    if (object.name != "office_roof" && object.name != "office_201") continue;
    ASSERT_FALSE(object.visuals.empty());
    for (const Visual& visual : object.visuals) {
      EXPECT_EQ(visual.casts_shadow, object.name == "office_roof") << object.name;
    }
  }
}

TEST(IndoorModule, CanStandsInTheLobbyOnTheGroundFloor) {
  const auto& vessels = Indoor().model().vessels;
  ASSERT_EQ(vessels.size(), 1u);
  EXPECT_EQ(vessels[0].name, "can_lobby");
  const Vector3d at = vessels[0].X_MV.translation();
  EXPECT_EQ(at.z(), 0);
  // The robot stands 1.05 m west of it and has room to turn there.
  for (double angle = 0; angle < 6.28; angle += 0.05) {
    const Vector3d middle(at.x() - 1.05, at.y(), 0.3);
    const double range = Range(middle, {std::cos(angle), std::sin(angle), 0});
    EXPECT_TRUE(range < 0 || range > kTurningRadius) << angle;
  }
}

}  // namespace
}  // namespace eod::sim
