#include "sim/segments/exact_test.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace eod::sim {
namespace {

using Eigen::Vector3d;

/// Triangle (0,0,0) (1,0,0) (0,1,0), facing up.
std::optional<double> MeetUnit(const Vector3d& start, const Vector3d& direction, double length,
                               FaceRule face_rule = FaceRule::kTwoSided) {
  return Meet({.start = start, .direction = direction, .length = length, .face_rule = face_rule},
              Vector3d::Zero(), Vector3d::UnitX(), Vector3d::UnitY());
}

const Vector3d kDown = -Vector3d::UnitZ();

TEST(ExactTest, EdgesAndCornersBelongToTheTriangle) {
  for (const auto& [x, y] : {std::pair(0.0, 0.0), std::pair(1.0, 0.0), std::pair(0.0, 1.0),
                             std::pair(0.5, 0.5), std::pair(0.5, 0.0), std::pair(0.0, 0.25)}) {
    EXPECT_EQ(MeetUnit({x, y, 2}, kDown, 3), 2.0) << x << ' ' << y;
  }
}

TEST(ExactTest, TheNextNumberBesideAnEdgeIsOutside) {
  const double beyond = std::nextafter(0.5, 1.0);
  EXPECT_FALSE(MeetUnit({0.5, -1e-50, 2}, kDown, 3));
  EXPECT_FALSE(MeetUnit({0.5, beyond, 2}, kDown, 3));
  EXPECT_TRUE(MeetUnit({0.5, std::nextafter(0.5, 0.0), 2}, kDown, 3));
}

TEST(ExactTest, BothEndsCountAndNothingBeyondThem) {
  EXPECT_EQ(MeetUnit({0.25, 0.25, 0}, kDown, 1), 0.0);
  EXPECT_EQ(MeetUnit({0.25, 0.25, 1}, kDown, 1), 1.0);
  EXPECT_EQ(MeetUnit({0.25, 0.25, 0}, kDown, 0), 0.0);
  EXPECT_FALSE(MeetUnit({0.25, 0.25, 1}, kDown, 1 - 2 * kEndTolerance));
  EXPECT_FALSE(MeetUnit({0.25, 0.25, -2 * kEndTolerance}, kDown, 1));
}

TEST(ExactTest, EdgeOnItIsNotThere) {
  EXPECT_FALSE(MeetUnit({-1, 0.25, 0}, Vector3d::UnitX(), 3));
  EXPECT_FALSE(MeetUnit({-1, 0, 0}, Vector3d::UnitX(), 3));  // along an edge
}

TEST(ExactTest, FrontIsWhereTheCornersRunCounterClockwise) {
  EXPECT_TRUE(MeetUnit({0.25, 0.25, 1}, kDown, 2, FaceRule::kFrontOnly));
  EXPECT_FALSE(MeetUnit({0.25, 0.25, -1}, Vector3d::UnitZ(), 2, FaceRule::kFrontOnly));
  EXPECT_TRUE(MeetUnit({0.25, 0.25, -1}, Vector3d::UnitZ(), 2));
}

TEST(ExactTest, SideIsExactWhereDoublesSeeNothing) {
  // b and c lie on one ray from s but for the last bit of one coordinate, 1.5 km from the origin.
  const Vector3d s(1500, 1500, 0), b(1501, 1501, 0);
  const double last_bit = std::nextafter(1502.0, 2000.0) - 1502.0;
  const Vector3d c(1502, 1502 + last_bit, 0);
  // z of (b - s) x (c - s) = 1 * (2 + bit) - 1 * 2.
  EXPECT_EQ(ExactSide(Vector3d::UnitZ(), s, b, c), last_bit);
  EXPECT_EQ(ExactSide(Vector3d::UnitZ(), s, c, b), -last_bit);
  EXPECT_EQ(ExactSide(Vector3d::UnitZ(), s, b, Vector3d(1502, 1502, 0)), 0);
}

TEST(ExactTest, RangeHoldsAtAGrazingAngle) {
  // Almost in the plane of a large triangle: one in ten million.
  const double angle = 1e-7, drop = 1e-6;
  const Vector3d direction(std::cos(angle), 0, -std::sin(angle));
  const auto range = Meet({.start = {-10, 10, drop}, .direction = direction, .length = 100},
                          {-500, -500, 0}, {1000, -500, 0}, {-500, 1000, 0});
  ASSERT_TRUE(range);
  EXPECT_NEAR(*range, drop / std::sin(angle), 1e-7);
}

}  // namespace
}  // namespace eod::sim
