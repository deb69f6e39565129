// The stations of the slope module, measured by casting segments.
#include <cmath>
#include <numbers>

#include "tests/unit/sim/training_ground.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kStart = 8.0;  // y where each obstacle begins

const BuiltModule& Slope() {
  static const BuiltModule module(2);
  return module;
}

TEST(SlopeModule, LiesWhereTheMapSays) {
  const ModuleModel& module = Slope().model();
  EXPECT_EQ(module.name, "slope");
  EXPECT_EQ(module.class_bit, kModuleSlope);
  EXPECT_EQ(module.p_WM, Vector3d(1000, 1000, 0));
  EXPECT_EQ(module.half_size, Eigen::Vector2d(60, 60));
  EXPECT_EQ(module.start_attitude, Attitude{});
  EXPECT_GE(module.objects.size(), 14u);
}

TEST(SlopeModule, EveryLaneCanBeDrivenToFromTheStart) {
  // North from the pad, along the cross lane, and up each lane to its mark: nothing stands within
  // 0.45 m beside the way, as high as the robot is.
  for (const double z : {0.05, 0.3, 0.9, 1.4}) {
    EXPECT_LT(Slope().Look({0, 0, z}, Vector3d::UnitX()).range, 0);
    for (const double side : {-0.45, 0.0, 0.45}) {
      EXPECT_LT(Slope().Look({-46, 4 + side, z}, Vector3d::UnitX()).range, 0);
      for (int lane = -11; lane <= 11; ++lane) {
        const double range = Slope().Look({4.0 * lane + side, 0, z}, Vector3d::UnitY()).range;
        EXPECT_TRUE(range < 0 || range > 7.0) << lane << " " << z;
      }
    }
  }
}

struct Plane {
  double x, angle_deg;
};

class InclinedPlane : public ::testing::TestWithParam<Plane> {};

TEST_P(InclinedPlane, RisesThreeMetresIsLevelForTwoAndFallsAgain) {
  const auto [x, angle_deg] = GetParam();
  const double run = 3 * std::cos(angle_deg * kDegree);
  const double rise = 3 * std::sin(angle_deg * kDegree);
  const std::string name = "ramp_" + std::to_string(static_cast<int>(angle_deg));
  for (const uint32_t proxy : {kClampProxy, kBumpProxy}) {
    for (const double side : {-1.19, 0.0, 1.19}) {
      for (const double share : {0.01, 0.5, 0.99}) {
        const double z = share * rise;
        EXPECT_NEAR(Slope().HeightAt(x + side, kStart + share * run, proxy), z, 1e-9);
        EXPECT_NEAR(Slope().HeightAt(x + side, kStart + 2 * run + 2 - share * run, proxy), z, 1e-9);
        EXPECT_NEAR(Slope().HeightAt(x + side, kStart + run + 2 * share, proxy), rise, 1e-9);
      }
    }
    const auto met = Slope().Look({x, kStart + run / 2, 5}, -Vector3d::UnitZ(), proxy);
    EXPECT_EQ(met.object, name);
    EXPECT_NEAR(std::acos(met.normal.z()) / kDegree, angle_deg, 1e-6);
  }
  EXPECT_EQ(Slope().HeightAt(x + 1.21, kStart + run), 0);
  EXPECT_EQ(Slope().HeightAt(x, kStart - 0.01), 0);
}

INSTANTIATE_TEST_SUITE_P(Angles, InclinedPlane,
                         ::testing::Values(Plane{4, 10}, Plane{8, 15}, Plane{12, 20}, Plane{16, 25},
                                           Plane{20, 30}, Plane{24, 35}, Plane{28, 42}));

TEST(SlopeModule, SideSlopesLeanToTheLeftAndLeadThereGently) {
  for (const auto& [x, angle_deg] : {Plane{32, 10}, Plane{36, 15}, Plane{40, 20}}) {
    for (const double y : {2.51, 4.0, 5.49}) {
      for (const double side : {-1.1, 0.0, 1.1}) {
        EXPECT_NEAR(Slope().HeightAt(x + side, kStart + y, kClampProxy),
                    (side + 1.2) * std::tan(angle_deg * kDegree), 1e-9);
      }
    }
    // Along the tracks: from the ground to the ground, in no step higher than 3 cm in 5.
    double before = 0;
    for (double y = -0.05; y < 8.1; y += 0.05) {
      const double height = Slope().HeightAt(x + 0.3, kStart + y, kClampProxy);
      EXPECT_LT(std::abs(height - before), 0.03) << x << " " << y;
      before = height;
    }
    EXPECT_EQ(before, 0);
  }
}

TEST(SlopeModule, HalfRampsCrossUnderTheTwoTracks) {
  // One track's tile is up where the other's is down: 0.59 m from foot to crest, 0.17 m high.
  for (int tile = 0; tile < 6; ++tile) {
    const double y = kStart + 0.59 * tile;
    const double rising = tile % 2 == 0 ? 1 : -1;
    EXPECT_NEAR(Slope().HeightAt(44 - 0.3, y + 0.295), 0.085, 1e-4);
    EXPECT_NEAR(Slope().HeightAt(44 - 0.3, y + 0.395), 0.085 + rising * 0.1 * 0.17 / 0.59, 1e-4);
    EXPECT_NEAR(Slope().HeightAt(44 + 0.3, y + 0.59 + 0.395), 0.085 + rising * 0.1 * 0.17 / 0.59,
                1e-4);
  }
  EXPECT_EQ(Slope().HeightAt(44 + 0.3, kStart + 0.3), 0);
  EXPECT_EQ(Slope().HeightAt(44 - 0.3, kStart + 6 * 0.59 + 0.01), 0);
}

struct Stair {
  double x;
  int first_flight, second_flight;
  double rise, run, landing;
};

class Stairs : public ::testing::TestWithParam<Stair> {
 protected:
  /// Nosings (y, z), from below.
  static std::vector<Eigen::Vector2d> Nosings() {
    const Stair& stair = GetParam();
    std::vector<Eigen::Vector2d> nosings;
    double y = kStart;
    for (int i = 1; i <= stair.first_flight + stair.second_flight; ++i) {
      nosings.emplace_back(y, i * stair.rise);
      y += i == stair.first_flight ? stair.landing : stair.run;
    }
    return nosings;
  }
};

TEST_P(Stairs, BumpMeetsTreadsAndRisers) {
  const Stair& stair = GetParam();
  double below = 0;
  for (const auto& nosing : Nosings()) {
    EXPECT_NEAR(Slope().HeightAt(stair.x, nosing.x() + 0.01), nosing.y(), 1e-9);
    EXPECT_NEAR(Slope().HeightAt(stair.x, nosing.x() - 0.01), below, 1e-9);
    const auto riser =
        Slope().Look({stair.x, nosing.x() - 0.1, (below + nosing.y()) / 2}, Vector3d::UnitY());
    EXPECT_NEAR(riser.range, 0.1, 1e-9) << "riser at " << nosing.transpose();
    below = nosing.y();
  }
}

TEST_P(Stairs, ClampIsTheLineThroughTheNosings) {
  const Stair& stair = GetParam();
  const double slope = stair.rise / stair.run;
  const auto nosings = Nosings();
  for (size_t i = 0; i < nosings.size(); ++i) {
    const auto& nosing = nosings[i];
    EXPECT_NEAR(Slope().HeightAt(stair.x, nosing.x(), kClampProxy), nosing.y(), 1e-4);
    if (i == 0 || static_cast<int>(i) == stair.first_flight) continue;
    const double middle = nosing.x() - stair.run / 2;
    EXPECT_NEAR(Slope().HeightAt(stair.x, middle, kClampProxy), nosing.y() - slope * stair.run / 2,
                1e-9);
  }
  // The lead-in: as long as the small wheels' radius, 0.10 m.
  for (const size_t first : {0, stair.first_flight}) {
    if (first == nosings.size()) continue;
    const auto& nosing = nosings[first];
    const double below = nosing.y() - stair.rise;
    EXPECT_NEAR(Slope().HeightAt(stair.x, nosing.x() - 0.101, kClampProxy), below, 1e-9);
    EXPECT_NEAR(Slope().HeightAt(stair.x, nosing.x() - 0.05, kClampProxy), below + stair.rise / 2,
                1e-9);
  }
  // No height changes by more than the lead-in's slope, up to the platform and down the ramp.
  double before = 0;
  for (double y = kStart - 0.2; y < 22; y += 0.01) {
    const double height = Slope().HeightAt(stair.x, y, kClampProxy);
    EXPECT_LE(std::abs(height - before), 0.01 * stair.rise / 0.1 + 1e-4) << y;
    before = height;
  }
  EXPECT_EQ(before, 0);
}

TEST_P(Stairs, PlatformOfTwoMetresFollows) {
  const Stair& stair = GetParam();
  const auto last = Nosings().back();
  for (const uint32_t proxy : {kClampProxy, kBumpProxy}) {
    EXPECT_NEAR(Slope().HeightAt(stair.x, last.x() + 0.01, proxy), last.y(), 1e-9);
    EXPECT_NEAR(Slope().HeightAt(stair.x, last.x() + 1.99, proxy), last.y(), 1e-9);
    EXPECT_LT(Slope().HeightAt(stair.x, last.x() + 2.05, proxy), last.y());
  }
}

INSTANTIATE_TEST_SUITE_P(Flights, Stairs,
                         ::testing::Values(Stair{-4, 10, 0, 0.150, 0.300, 0},
                                           Stair{-8, 9, 0, 0.165, 0.280, 0},
                                           Stair{-12, 6, 6, 0.175, 0.260, 1.5}));

TEST(SlopeModule, KerbAndBarsAreAsHighAsTheySay) {
  EXPECT_NEAR(Slope().Look({0, 6, 0.1}, Vector3d::UnitY()).range, 2, 1e-9);
  EXPECT_NEAR(Slope().HeightAt(0, 9), 0.15, 1e-12);
  EXPECT_NEAR(Slope().HeightAt(0, kStart - 0.1, kClampProxy), 0.075, 1e-9);
  EXPECT_EQ(Slope().HeightAt(0, kStart - 0.1), 0);
  for (const auto& [x, height] : {std::pair(-16, 0.10), {-20, 0.20}, {-24, 0.40}, {-28, 0.55}}) {
    // Round for tracks and feelers alike, within the circle by which its mesh has 24 faces.
    const double radius = height / 2;
    const double inner = radius * std::cos(std::numbers::pi / 24);
    for (const double y : {-0.9 * radius, -0.5 * radius, 0.0, 0.5 * radius, 0.9 * radius}) {
      for (const uint32_t proxy : {kClampProxy, kBumpProxy}) {
        const double top = Slope().HeightAt(x, kStart + y, proxy);
        EXPECT_LE(top, radius + std::sqrt(radius * radius - y * y) + 1e-9);
        EXPECT_GE(top, radius + std::sqrt(inner * inner - y * y) - 1e-9);
      }
    }
    EXPECT_NEAR(Slope().HeightAt(x, kStart, kClampProxy), height, 1e-9);
    EXPECT_EQ(Slope().HeightAt(x, kStart - 1.1 * radius, kClampProxy), 0);
  }
}

TEST(SlopeModule, DitchesAreHolesInTheGround) {
  for (const auto& [x, width] : {std::pair(-32, 0.40), {-36, 0.60}, {-40, 0.90}}) {
    for (const uint32_t proxy : {kClampProxy, kBumpProxy}) {
      for (const double side : {-1.19, 0.0, 1.19}) {
        EXPECT_NEAR(Slope().HeightAt(x + side, kStart - 0.001, proxy), 0, 1e-12);
        EXPECT_NEAR(Slope().HeightAt(x + side, kStart + 0.001, proxy), -0.3, 1e-12);
        EXPECT_NEAR(Slope().HeightAt(x + side, kStart + width - 0.001, proxy), -0.3, 1e-12);
        EXPECT_NEAR(Slope().HeightAt(x + side, kStart + width + 0.001, proxy), 0, 1e-12);
      }
      const Vector3d inside(x, kStart + width / 2, -0.15);
      EXPECT_NEAR(Slope().Look(inside, Vector3d::UnitY(), proxy).range, width / 2, 1e-9);
      EXPECT_NEAR(Slope().Look(inside, -Vector3d::UnitY(), proxy).range, width / 2, 1e-9);
    }
  }
}

TEST(SlopeModule, GroundHasNoOtherHoles) {
  for (double x = -59; x < 60; x += 0.83) {
    for (double y = -59; y < 60; y += 0.79) {
      for (const uint32_t proxy : {kClampProxy, kBumpProxy}) {
        EXPECT_GE(Slope().HeightAt(x, y, proxy), -0.3 - 1e-12) << x << " " << y;
      }
    }
  }
}

TEST(SlopeModule, StepfieldStaysBelowTwentyCentimetresAndUnderItsSkin) {
  for (int row = 0; row < 15; ++row) {
    for (int column = 0; column < 6; ++column) {
      const double x = -44 - 0.5 + 0.2 * column;
      const double y = kStart + 0.1 + 0.2 * row;
      const double height = Slope().HeightAt(x, y);
      EXPECT_GE(height, 0);
      EXPECT_LE(height, 0.2 + 1e-9);
      EXPECT_NEAR(height / 0.05, std::round(height / 0.05), 1e-9);
      EXPECT_LE(std::abs(Slope().HeightAt(x, y + (row < 14 ? 0.2 : 0)) - height), 0.1 + 1e-9);
      for (const double dx : {-0.09, 0.09}) {
        for (const double dy : {-0.09, 0.09}) {
          EXPECT_GE(Slope().HeightAt(x + dx, y + dy, kClampProxy) + 1e-9, height);
        }
      }
    }
  }
}

}  // namespace
}  // namespace eod::sim
