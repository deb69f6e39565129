#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/disposal/bench.h"

namespace eod::sim {
namespace {

double HalfChord(double a, double delta) { return std::sqrt(2 * a * delta - delta * delta); }

bool IsCandidate(Bench& bench) {
  bench.Look(DemandFor({kGripperClose}));
  return GraspCandidate(bench.Lines()) == 0;
}

TEST(GraspGolden34, CentredAndPressedByThreeMillimetres) {
  Bench bench;
  constexpr double kA = 0.06, kDelta = 0.003;
  bench.Open(kA - kDelta);
  bench.PlaceInHand(0, 0);
  EXPECT_TRUE(IsCandidate(bench));
  const double half_chord = HalfChord(kA, kDelta);
  EXPECT_NEAR(bench.Range("l1"), half_chord, 1e-9);
  EXPECT_NEAR(bench.Range("l2"), half_chord, 1e-9);
  EXPECT_NEAR(half_chord, 0.0187, 0.00005);
  EXPECT_NEAR(bench.Range("l3"), 0.117, 1e-9);
  EXPECT_NEAR(bench.Range("l5"), 0.08 - half_chord, 1e-9);
  EXPECT_NEAR(bench.Range("l5"), 0.0613, 0.00005);
  EXPECT_NEAR(bench.Range("l9"), 0.058, 1e-9);
  for (const char* line : {"l4", "l6", "l7", "l8"}) EXPECT_EQ(bench.Range(line), -1) << line;
}

TEST(GraspGolden34, NotTouchedByAMillimetre) {
  Bench bench;
  bench.Open(0.061);
  bench.PlaceInHand(0, 0);
  EXPECT_FALSE(IsCandidate(bench));
  EXPECT_NEAR(bench.Range("l3"), 0.001, 1e-9);
  EXPECT_NEAR(bench.Range("l9"), 0.0607, 0.00005);
  for (const char* line : {"l1", "l2", "l5"}) EXPECT_EQ(bench.Range(line), -1) << line;
}

TEST(GraspGolden34, TwentyFiveMillimetresLeftTouchesTheLeftHandAlone) {
  Bench bench;
  bench.Open(0.08);
  bench.PlaceInHand(-0.025, 0);
  EXPECT_FALSE(IsCandidate(bench));
  EXPECT_NEAR(bench.Range("l1"), 0.0240, 0.00005);
  EXPECT_NEAR(bench.Range("l2"), 0.0240, 0.00005);
  EXPECT_NEAR(bench.Range("l3"), 0.115, 1e-9);
  EXPECT_EQ(bench.Range("l5"), -1);
}

TEST(GraspGolden34, CentringWindowIsTheHalfChord) {
  // The design's table, mm along the finger for radius and compression.
  const double table[4][4] = {{7, 10, 13, 16}, {9, 13, 16, 20}, {10, 15, 18, 23}, {12, 17, 21, 26}};
  const double radii[] = {0.030, 0.045, 0.060, 0.075}, deltas[] = {0.001, 0.002, 0.003, 0.005};
  for (int i = 0; i < 4; ++i) {
    Bench bench(BombModule({Cylinder(radii[i], 0.12, 3)}));
    for (int j = 0; j < 4; ++j) {
      const double window = HalfChord(radii[i], deltas[j]);
      EXPECT_NEAR(1000 * window, table[i][j], 1.0);
      bench.Open(radii[i] - deltas[j]);
      for (const double side : {-1, 1}) {
        bench.PlaceInHand(0, side * (window - 0.0002));
        EXPECT_TRUE(IsCandidate(bench)) << radii[i] << " " << deltas[j] << " " << side;
        bench.PlaceInHand(0, side * (window + 0.0002));
        EXPECT_FALSE(IsCandidate(bench)) << radii[i] << " " << deltas[j] << " " << side;
      }
    }
  }
}

TEST(GraspGolden34, WithL6InsteadOfL5ThePredicateHasHardlyASolution) {
  // The inward line of the right tip, 80 mm ahead, meets a charge of radius a only if that is off
  // by more than 80 - a, and l1 and l2 only within 13, 16, 18, 21 mm at 3 mm of compression.
  for (const double a : {0.030, 0.045, 0.060, 0.075}) {
    Bench bench(BombModule({Cylinder(a, 0.12, 3)}));
    bench.Open(a - 0.003);
    for (double mm = -25.5; mm < 26; ++mm) {
      bench.PlaceInHand(0, mm / 1000);
      bench.Look(DemandFor({kGripperClose}));
      const bool with_l6 = bench.Range("l1") > 0 && bench.Range("l2") > 0 && bench.Range("l6") > 0;
      EXPECT_EQ(with_l6, a == 0.075 && mm > 5 && mm < 21) << a << " " << mm;
      // l4 looks ahead of the tip and never sees a charge that can be grasped.
      EXPECT_FALSE(bench.Range("l4") > 0 && GraspCandidate(bench.Lines()) == 0);
    }
  }
}

TEST(GraspGolden34, AllFiveLinesHaveToSeeTheSameCharge) {
  HandLines lines;
  EXPECT_EQ(GraspCandidate(lines), -1);
  for (const int line : {kL1, kL2, kL3, kL5, kL9}) lines[line].charge = 4;
  EXPECT_EQ(GraspCandidate(lines), 4);
  for (const int line : {kL1, kL2, kL3, kL5, kL9}) {
    HandLines other = lines;
    other[line].charge = 5;
    EXPECT_EQ(GraspCandidate(other), -1);
    other[line].charge = -1;
    EXPECT_EQ(GraspCandidate(other), -1);
  }
}

TEST(Eq8, MantleAndEndCapsOfAnUprightCharge) {
  const ExplosiveSpec charge{0.06, 0.12};
  const Eigen::Isometry3d X_MO(Eigen::Translation3d(3, -2, 0.12));
  const auto on = [&](double x, double y, double z) {
    return IsOnCharge(charge, X_MO, X_MO * Eigen::Vector3d(x, y, z), 1e-9);
  };
  EXPECT_TRUE(on(0.06, 0, 0));
  EXPECT_TRUE(on(0.06 * 0.6, -0.06 * 0.8, 0.12));
  EXPECT_TRUE(on(0.02, 0.01, 0.12));
  EXPECT_TRUE(on(0, 0, -0.12));
  EXPECT_FALSE(on(0.05, 0, 0.1));
  EXPECT_FALSE(on(0.06, 0, 0.121));
  EXPECT_FALSE(on(0.061, 0, 0.12));
}

TEST(Eq8, HoldsInTheFrameOfATiltedCharge) {
  const ExplosiveSpec charge{0.06, 0.12};
  Eigen::Isometry3d X_MO(Eigen::Translation3d(1, 2, 0.3));
  X_MO.rotate(Eigen::AngleAxisd(70 * kDegree, Eigen::Vector3d::UnitX()));
  EXPECT_TRUE(IsOnCharge(charge, X_MO, X_MO * Eigen::Vector3d(0, 0.06, 0.1), 1e-9));
  EXPECT_FALSE(IsOnCharge(charge, X_MO, Eigen::Vector3d(1.06, 2, 0.4), 1e-3));
}

TEST(Eq8, ToleratesAPolygonForACircle) {
  // Middle of an edge of an N-gon: a (1 - cos(pi / N)) within the circle, 1.15 mm and 0.29 mm.
  const ExplosiveSpec charge{0.06, 0.12};
  for (const auto& [edges, tolerance] : {std::pair{16, 0.00116}, {32, 0.00029}}) {
    const double inside = 0.06 * (1 - std::cos(std::numbers::pi / edges));
    const Eigen::Vector3d p_M(0.06 - inside, 0, 0.03);
    EXPECT_TRUE(IsOnCharge(charge, Eigen::Isometry3d::Identity(), p_M, tolerance));
    EXPECT_FALSE(IsOnCharge(charge, Eigen::Isometry3d::Identity(), p_M, 0.9 * inside));
  }
  EXPECT_GT(TheRules().grasp.surface_tolerance, 0.00115);
}

}  // namespace
}  // namespace eod::sim
