#include "sim/stance/gravity_centre.h"

#include <numbers>

#include <gtest/gtest.h>

namespace eod::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

class GravityCentre : public ::testing::Test {
 protected:
  RobotModel robot_ = LoadRobot(EOD_DATA_DIR "/sim/robots/eod_robot.sdf");
  RobotState state_ = HomeState(robot_);
  std::vector<Eigen::Isometry3d> X_ML_;

  /// Arm straight forward, with a load in the centre of the hand.
  Eigen::Vector3d AtFullStretch(double load_kg) {
    state_.joint[kBigArm] = 0;
    state_.joint[kSmallArm] = 180 * kDegree;
    state_.joint[kWrist] = 0;
    LinkPoses(robot_, state_, X_ML_);
    const Eigen::Vector3d hand_M =
        X_ML_[FindLink(robot_, "gripper")] * Eigen::Vector3d(0, 0.15 + 0.08, 0);
    return CentreOfGravity(robot_, X_ML_, {.mass = load_kg, .p_M = hand_M});
  }
};

TEST_F(GravityCentre, LinksWeigh180Kilograms) {
  double mass = 0;
  for (const LinkSpec& link : robot_.links) mass += link.mass;
  EXPECT_NEAR(mass, 180, 1e-9);
}

// Golden numbers of the design, 2.3: y = 0.108 / 0.169 / 0.218 for 0 / 8 / 15 kg at full stretch.
TEST_F(GravityCentre, MeetsTheGoldenNumbersAtFullStretch) {
  EXPECT_NEAR(AtFullStretch(0).y(), 0.108, 0.0005);
  EXPECT_NEAR(AtFullStretch(8).y(), 0.169, 0.0005);
  EXPECT_NEAR(AtFullStretch(15).y(), 0.218, 0.0005);
}

TEST_F(GravityCentre, GoesWhereTheArmGoes) {
  const double forward = AtFullStretch(0).y();
  state_.joint[kBigArm] = 150 * kDegree;
  LinkPoses(robot_, state_, X_ML_);
  const Eigen::Vector3d up = CentreOfGravity(robot_, X_ML_);
  EXPECT_LT(up.y(), forward - 0.1);
  EXPECT_LT(std::abs(up.x()), 0.01);  // the mast stands to the left
}

TEST_F(GravityCentre, MovesAndTurnsWithTheRobot) {
  LinkPoses(robot_, state_, X_ML_);
  const Eigen::Vector3d p_B = CentreOfGravity(robot_, X_ML_);
  state_.position = {3, -2, 0.5};
  state_.attitude = {1.0, 0.2, -0.3};
  LinkPoses(robot_, state_, X_ML_);
  EXPECT_LT((CentreOfGravity(robot_, X_ML_) - X_ML_[0] * p_B).norm(), 1e-12);
}

}  // namespace
}  // namespace eod::sim
