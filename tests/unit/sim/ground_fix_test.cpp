#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/isectors/isector_set.h"
#include "sim/world/analytic_world.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;
constexpr uint32_t kGround = kModuleFlat | kClampProxy;

/// One link with a TRIPOD of the golden test: legs (-0.30, 0.40), (0.30, 0.40), (0, -0.40).
RobotModel TripodRobot() {
  RobotModel robot;
  robot.links.push_back({.name = "chassis"});
  IsectorSpec tripod{.name = "TRIPOD",
                     .method = IsectorMethod::kTripod,
                     .class_mask = kClampProxy,
                     .motions = kAllMotions | kAlways,
                     .segments = {}};
  for (const auto& [x, y] :
       {std::pair(-0.30, 0.40), std::pair(0.30, 0.40), std::pair(0.0, -0.40)}) {
    tripod.segments.push_back({.name = "leg",
                               .start = {x, y, 0.45},
                               .direction = -Vector3d::UnitZ(),
                               .length = 3.45,
                               .motions = kAllMotions | kAlways});
  }
  robot.isectors.push_back(std::move(tripod));
  return robot;
}

class Tripod : public ::testing::Test {
 protected:
  RobotModel robot_ = TripodRobot();
  AnalyticWorld world_;
  IsectorSet dut_{robot_, kModuleFlat};

  const GroundFix& Stand(const Vector3d& position, const Attitude& attitude) {
    Eigen::Isometry3d X_ML = Eigen::Isometry3d::Identity();
    X_ML.linear() = ToRotation(attitude);
    X_ML.translation() = position;
    dut_.Cast(world_, {&X_ML, 1}, 0);
    return dut_.ground();
  }
  void AddTower(double x, double y, double top) {
    world_.AddBox("tower", kGround, Eigen::Isometry3d(Eigen::Translation3d(x, y, top - 5)),
                  {0.2, 0.2, 10});
  }
};

TEST_F(Tripod, MeetsTheGoldenPlane) {
  // Plane of pitch 20 deg at heading 30 deg through the origin: its up axis is that of the
  // attitude.
  const Attitude attitude{30 * kDegree, 20 * kDegree, 0};
  world_.AddPlane("slope", kGround, Vector3d::Zero(), ToRotation(attitude).col(2));
  const GroundFix& ground = Stand(Vector3d::Zero(), {30 * kDegree, 0, 0});
  ASSERT_EQ(ground.legs, 3);
  // Golden hits to five places.
  const std::array<Vector3d, 3> golden = {Vector3d(-0.45981, 0.19641, 0.14559),
                                          Vector3d(0.05981, 0.49641, 0.14559),
                                          Vector3d(0.20000, -0.34641, -0.14559)};
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_LT((dut_.segments()[i].hit.point - golden[i]).norm(), 1e-5);
  }
  const Attitude answer = AttitudeOnPlane(ground.normal, 30 * kDegree);
  EXPECT_NEAR(ground.height, 0, 1e-12);
  EXPECT_NEAR(answer.pitch, 20 * kDegree, 1e-12);
  EXPECT_NEAR(answer.roll, 0, 1e-12);
}

TEST_F(Tripod, AnswerDoesNotDependOnTheAttitudeItIsAskedFrom) {
  const Attitude slope{30 * kDegree, 20 * kDegree, 5 * kDegree};
  world_.AddPlane("slope", kGround, Vector3d::Zero(), ToRotation(slope).col(2));
  for (const double pitch : {-10.0, 0.0, 20.0}) {
    const GroundFix& ground = Stand({0.1, 0.2, 0.1}, {30 * kDegree, pitch * kDegree, 0.05});
    const Attitude answer = AttitudeOnPlane(ground.normal, 30 * kDegree);
    EXPECT_NEAR(answer.pitch, 20 * kDegree, 1e-9);
    EXPECT_NEAR(answer.roll, 5 * kDegree, 1e-9);
  }
}

TEST_F(Tripod, TakesTheHighestGroundUpToTheStepLimit) {
  world_.AddPlane("floor", kGround, Vector3d::Zero(), Vector3d::UnitZ());
  world_.AddPlane("roof", kGround, {0, 0, 3}, Vector3d::UnitZ());
  world_.AddPlane("kerb", kGround, {0, 0, 0.15}, Vector3d::UnitZ());
  EXPECT_NEAR(Stand(Vector3d::Zero(), {}).height, 0.15, 1e-12);  // not the roof
}

TEST_F(Tripod, TwoLegsMoveByTheirMeanAndKeepTheAttitude) {
  AddTower(-0.30, 0.40, -0.10);
  AddTower(0.30, 0.40, -0.20);
  const GroundFix& ground = Stand(Vector3d::Zero(), {});
  EXPECT_EQ(ground.legs, 2);
  EXPECT_NEAR(ground.mean_offset, -0.15, 1e-12);
  EXPECT_NEAR(ground.height, -0.15, 1e-12);
  EXPECT_EQ(ground.normal, Vector3d::UnitZ());
}

TEST_F(Tripod, OneLegIsMeasuredFromTheRobotsOwnPlane) {
  AddTower(0, -0.40, 0.0);
  // Nose up by 10 deg: the plane of the robot lies 0.40 tan 10 deg below its origin at the rear
  // leg.
  const GroundFix& ground = Stand({0, 0, 0.3}, {0, 10 * kDegree, 0});
  EXPECT_EQ(ground.legs, 1);
  EXPECT_NEAR(ground.mean_offset, -(0.3 - 0.40 * std::tan(10 * kDegree)), 1e-12);
}

TEST_F(Tripod, NoLegFindsNothing) {
  world_.AddPlane("far below", kGround, {0, 0, -3.2}, Vector3d::UnitZ());
  EXPECT_EQ(Stand(Vector3d::Zero(), {}).legs, 0);
}

TEST_F(Tripod, StandsOnClampProxiesOnly) {
  world_.AddPlane("risers", kModuleFlat | kBumpProxy, {0, 0, 0.1}, Vector3d::UnitZ());
  world_.AddPlane("other module", kModuleSlope | kClampProxy, {0, 0, 0.2}, Vector3d::UnitZ());
  EXPECT_EQ(Stand(Vector3d::Zero(), {}).legs, 0);
}

}  // namespace
}  // namespace eod::sim
