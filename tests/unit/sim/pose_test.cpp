#include "sim/geometry/pose.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace eod::sim {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;

Attitude FromDegrees(double heading, double pitch, double roll) {
  return {heading * kDegree, pitch * kDegree, roll * kDegree};
}

/// Eq. 1: the point at distance D ahead of a part's centre.
Vector3d PointAhead(const Attitude& attitude, double distance) {
  return ToRotation(attitude) * Vector3d(0, distance, 0);
}

TEST(Pose, PointAheadFollowsEquation1) {
  // (h, p) = (0, 0), (90, 0), (0, 90): straight north, west, up.
  EXPECT_LT((PointAhead(FromDegrees(0, 0, 0), 0.4) - Vector3d(0, 0.4, 0)).norm(), 1e-15);
  EXPECT_LT((PointAhead(FromDegrees(90, 0, 0), 0.4) - Vector3d(-0.4, 0, 0)).norm(), 1e-15);
  EXPECT_LT((PointAhead(FromDegrees(0, 90, 0), 0.4) - Vector3d(0, 0, 0.4)).norm(), 1e-15);
  // (30, 20), D = 0.4: -D cos p sin h, D cos p cos h, D sin p to six places.
  const Vector3d golden(-0.187939, 0.325519, 0.136808);
  EXPECT_LT((PointAhead(FromDegrees(30, 20, 0), 0.4) - golden).norm(), 1e-6);
}

TEST(Pose, RollDoesNotMoveThePointAhead) {
  const Vector3d level = PointAhead(FromDegrees(30, 20, 0), 0.4);
  for (const double roll : {-170.0, -33.0, 45.0, 120.0}) {
    const Vector3d rolled = PointAhead(FromDegrees(30, 20, roll), 0.4);
    EXPECT_LT((rolled - level).norm(), 1e-15);
    EXPECT_NEAR(rolled.norm(), 0.4, 1e-15);
  }
}

TEST(Pose, PositiveRollPutsTheRightSideDown) {
  EXPECT_NEAR((ToRotation(FromDegrees(0, 0, 10)) * Vector3d::UnitX()).z(), -std::sin(10 * kDegree),
              1e-15);
}

TEST(Pose, RotationIsHeadingThenPitchThenRoll) {
  const Attitude attitude = FromDegrees(140, 15, -20);
  const Eigen::Matrix3d expected = (Eigen::AngleAxisd(attitude.heading, Vector3d::UnitZ()) *
                                    Eigen::AngleAxisd(attitude.pitch, Vector3d::UnitX()) *
                                    Eigen::AngleAxisd(attitude.roll, Vector3d::UnitY()))
                                       .toRotationMatrix();
  EXPECT_TRUE(ToRotation(attitude).isApprox(expected, 1e-14));
}

TEST(Pose, AttitudeComesBackFromItsRotation) {
  for (const Attitude& attitude : {FromDegrees(0, 10, 0), FromDegrees(335, -12, 8),
                                   FromDegrees(140, 15, -20), FromDegrees(359.9, 89, 170)}) {
    const Attitude back = ToAttitude(ToRotation(attitude));
    EXPECT_NEAR(back.heading, attitude.heading, 1e-12);
    EXPECT_NEAR(back.pitch, attitude.pitch, 1e-12);
    EXPECT_NEAR(back.roll, attitude.roll, 1e-12);
  }
}

TEST(Pose, AttitudeOnPlaneComesBackFromThePlanesUpAxis) {
  // Round trip of the formulas p = atan2(-n.f, n.z), r = asin(n.s) at the golden attitudes.
  for (const Attitude& attitude :
       {FromDegrees(0, 10, 0), FromDegrees(25, -12, 8), FromDegrees(140, 15, -20)}) {
    const Vector3d up = ToRotation(attitude).col(2);
    const Attitude back = AttitudeOnPlane(up, attitude.heading);
    EXPECT_NEAR(back.heading, attitude.heading, 1e-15);
    EXPECT_NEAR(back.pitch, attitude.pitch, 1e-15);
    EXPECT_NEAR(back.roll, attitude.roll, 1e-15);
  }
}

TEST(Pose, HeadingWrapsIntoOneTurn) {
  constexpr double kTurn = 2 * std::numbers::pi;
  EXPECT_DOUBLE_EQ(WrapHeading(-0.5), kTurn - 0.5);
  EXPECT_DOUBLE_EQ(WrapHeading(kTurn), 0);
  EXPECT_DOUBLE_EQ(WrapHeading(3 * kTurn + 1), 1);
  EXPECT_LT(WrapHeading(-1e-20), kTurn);  // rounds up to a whole turn if not watched
}

}  // namespace
}  // namespace eod::sim
