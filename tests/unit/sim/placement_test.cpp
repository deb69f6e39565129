#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/geometry/pose.h"
#include "sim/isectors/isector_set.h"
#include "sim/world/analytic_world.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;

/// Eq. 1 of the source paper places an isector at a part's point, D along its forward axis. Here
/// X_LI of the isector and the start of the segment do that, on any link and with an offset aside.
class Equation1 : public ::testing::Test {
 protected:
  AnalyticWorld world_;

  /// Where the segment of an isector at `p_LI` of a part in this pose starts.
  SegmentQuery Place(const Vector3d& p_LI, const Vector3d& position, const Attitude& attitude,
                     const Vector3d& start = Vector3d::Zero()) {
    RobotModel robot;
    robot.links.push_back({.name = "part"});
    IsectorSpec sight{.name = "sight",
                      .method = IsectorMethod::kLos,
                      .X_LI = Eigen::Isometry3d(Eigen::Translation3d(p_LI)),
                      .motions = kAllMotions | kAlways,
                      .segments = {}};
    sight.segments.push_back({.name = "+Y", .start = start, .length = 1, .motions = kAlways});
    robot.isectors.push_back(sight);
    Eigen::Isometry3d X_ML = Eigen::Isometry3d::Identity();
    X_ML.linear() = ToRotation(attitude);
    X_ML.translation() = position;
    IsectorSet dut(robot, kModuleFlat);
    dut.Cast(world_, {&X_ML, 1}, 0);
    return dut.segments()[0].query;
  }
  Vector3d PointAhead(double d, double heading_deg, double pitch_deg, double roll_deg = 0) {
    return Place({0, d, 0}, Vector3d::Zero(),
                 {heading_deg * kDegree, pitch_deg * kDegree, roll_deg * kDegree})
        .start;
  }
};

TEST_F(Equation1, MeetsTheGoldenVectors) {
  constexpr double kD = 0.7;
  EXPECT_LT((PointAhead(kD, 0, 0) - Vector3d(0, kD, 0)).norm(), 1e-12);
  EXPECT_LT((PointAhead(kD, 90, 0) - Vector3d(-kD, 0, 0)).norm(), 1e-12);
  EXPECT_LT((PointAhead(kD, 0, 90) - Vector3d(0, 0, kD)).norm(), 1e-12);
  // Given to six places.
  EXPECT_LT((PointAhead(0.4, 30, 20) - Vector3d(-0.187939, 0.325519, 0.136808)).norm(), 1e-6);
}

TEST_F(Equation1, IsItsCorrectedFormAtAnyAttitudeAndRollDoesNotEnter) {
  const Vector3d p0(3, -2, 0.5);
  constexpr double kD = 0.4;
  for (const double h : {-170.0, -45.0, 0.0, 30.0, 120.0}) {
    for (const double p : {-60.0, 0.0, 20.0, 80.0}) {
      for (const double r : {-90.0, 0.0, 35.0}) {
        const Attitude attitude{h * kDegree, p * kDegree, r * kDegree};
        const Vector3d point = Place({0, kD, 0}, p0, attitude).start;
        const Vector3d corrected(p0.x() - kD * std::cos(p * kDegree) * std::sin(h * kDegree),
                                 p0.y() + kD * std::cos(p * kDegree) * std::cos(h * kDegree),
                                 p0.z() + kD * std::sin(p * kDegree));
        EXPECT_LT((point - corrected).norm(), 1e-12) << h << " " << p << " " << r;
        EXPECT_NEAR((point - p0).norm(), kD, 1e-12);
        // The paper's 57.296 is 180 / pi to 3.85e-6, at most 1.2e-5 of D at half a turn.
        const double paper = 57.296;
        const double x = p0.x() - kD * std::cos(p / paper) * std::sin(h / paper);
        EXPECT_NEAR(point.x(), x, 2e-5 * kD);
      }
    }
  }
}

TEST_F(Equation1, PrintedSignOfYPutsThePointBehindThePart) {
  // y = y0 - D cos p cos h, as printed: at h = 0 that is behind the part by D instead of ahead, an
  // error of 2 D. The paper's own code has the plus.
  constexpr double kD = 0.4;
  const Vector3d printed(0, -kD, 0);
  EXPECT_NEAR((PointAhead(kD, 0, 0) - printed).norm(), 2 * kD, 1e-12);
}

TEST_F(Equation1, CopiesTheAttitudeOfThePart) {
  const Attitude attitude{30 * kDegree, 20 * kDegree, 10 * kDegree};
  const Vector3d along = Place({0, 0.4, 0}, Vector3d::Zero(), attitude).direction;
  EXPECT_LT((along - ToRotation(attitude).col(1)).norm(), 1e-12);
}

TEST_F(Equation1, WheelsStandAsideOfTheAxisToo) {
  // P = P0 + R (w, D, 0): the right wheel of a flipper that points up stands right of it.
  const Attitude up{0, 90 * kDegree, 0};
  const Vector3d wheel = Place({0.30, 0.40, 0}, {0, 0.375, 0.20}, up).start;
  EXPECT_LT((wheel - Vector3d(0.30, 0.375, 0.60)).norm(), 1e-12);
}

TEST_F(Equation1, StartsOfSegmentsAddInTheIsectorsFrame) {
  const Attitude left{90 * kDegree, 0, 0};
  const Vector3d start = Place({0, 0.5, 0}, {1, 1, 0}, left, {0.2, 0.1, 0.3}).start;
  // Forward is -X, right is +Y: 0.5 + 0.1 forward, 0.2 to the right.
  EXPECT_LT((start - Vector3d(1 - 0.6, 1 + 0.2, 0.3)).norm(), 1e-12);
}

}  // namespace
}  // namespace eod::sim
