#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/robot/robot_model.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kHandCentre = 0.08;  // [m] ahead of the crossbeam, half a finger
constexpr double kFinger = 0.16;

class Kinematics : public ::testing::Test {
 protected:
  static const RobotModel& Robot() {
    static const RobotModel model = LoadRobot(EOD_DATA_DIR "/sim/robots/eod_robot.sdf");
    return model;
  }
  const RobotModel& robot_ = Robot();
  RobotState state_ = HomeState(robot_);
  std::vector<Eigen::Isometry3d> X_WL_;

  const Eigen::Isometry3d& Link(const char* name) {
    LinkPoses(robot_, state_, X_WL_);
    return X_WL_[static_cast<size_t>(FindLink(robot_, name))];
  }
  void SetArm(double big_deg, double small_deg, double wrist_deg) {
    state_.joint[kBigArm] = big_deg * kDegree;
    state_.joint[kSmallArm] = small_deg * kDegree;
    state_.joint[kWrist] = wrist_deg * kDegree;
  }
  /// Point on the fingers' middle line, `along` metres ahead of the closed crossbeam.
  Vector3d OnFingers(double along) { return Link("gripper") * Vector3d(0, 0.15 + along, 0); }
  double HandPitch() { return ToAttitude(Link("gripper").linear()).pitch / kDegree; }
};

TEST_F(Kinematics, PresetPosesBringTheHandToTheirTargets) {
  struct Row {
    double y, z, pitch;        // hand centre [m], hand [deg]
    double big, small, wrist;  // J3, J4, J5 [deg], rounded to 0.1
  };
  // 0.1 deg of rounding at 1.5 m of reach is 2.6 mm at most; the three roundings add up in part.
  for (const Row& row :
       {Row{1.20, 0.12, -20, 14.7, 108.7, 36.5}, Row{1.05, 0.12, -45, 24.2, 93.6, 17.2},
        Row{1.15, 0.87, 0, 54.3, 99.3, 26.4}, Row{1.30, 0.15, 0, 7.0, 123.9, 49.1},
        Row{0.85, 0.80, 0, 70.1, 65.5, 44.4}, Row{1.05, 1.15, -60, 57.1, 138.0, -75.1}}) {
    SetArm(row.big, row.small, row.wrist);
    const Vector3d hand = OnFingers(kHandCentre);
    EXPECT_NEAR(hand.x(), 0, 1e-12);
    EXPECT_NEAR(hand.y(), row.y, 0.002);
    EXPECT_NEAR(hand.z(), row.z, 0.002);
    EXPECT_NEAR(HandPitch(), row.pitch, 0.101);
  }
}

TEST_F(Kinematics, ReachAndHeightAreThoseOfTheDesign) {
  SetArm(0, 180, 0);  // straight forward: -0.10 + 0.75 + 0.65 + 0.15 + along
  EXPECT_NEAR(OnFingers(kHandCentre).y(), 1.53, 1e-9);
  EXPECT_NEAR(OnFingers(kFinger).y(), 1.61, 1e-9);
  SetArm(90, 180, 0);  // straight up: 0.55 + 0.75 + 0.65 + 0.15 + along
  EXPECT_NEAR(OnFingers(kHandCentre).z(), 2.18, 1e-9);
  EXPECT_NEAR(OnFingers(kFinger).z(), 2.26, 1e-9);
}

TEST_F(Kinematics, PitchesAddUpAlongTheArm) {
  SetArm(70, 65, -20);
  state_.attitude.pitch = 5 * kDegree;  // body pitch adds to all
  EXPECT_NEAR(ToAttitude(Link("big_arm").linear()).pitch, 75 * kDegree, 1e-9);
  // small = J3 + J4 - 180 = -45, hand = small + J5 = -65
  EXPECT_NEAR(ToAttitude(Link("small_arm").linear()).pitch, -40 * kDegree, 1e-9);
  EXPECT_NEAR(HandPitch(), -60, 1e-9);
}

TEST_F(Kinematics, FlippersTurnAboutTheAxlesAndRaiseTheirTips) {
  state_.joint[kFrontFlipper] = 30 * kDegree;
  state_.joint[kRearFlipper] = 30 * kDegree;
  const double ahead = 0.375 + 0.4 * std::cos(30 * kDegree);
  const double up = 0.20 + 0.4 * std::sin(30 * kDegree);
  EXPECT_LT((Link("front_flipper") * Vector3d(-0.3, 0.4, 0) - Vector3d(-0.3, ahead, up)).norm(),
            1e-9);
  // The rear frame looks back: its -X is the robot's right.
  EXPECT_LT((Link("rear_flipper") * Vector3d(-0.3, 0.4, 0) - Vector3d(0.3, -ahead, up)).norm(),
            1e-9);
}

TEST_F(Kinematics, HandsOpenApartAndTheCrossbeamSlidesBackByTwoThirds) {
  SetArm(0, 180, 0);
  state_.joint[kGripperOpening] = state_.left_opening = state_.right_opening = 0.12;
  // Gripper base at y = -0.10 + 0.75 + 0.65 = 1.30, beam 0.15 ahead; 2/3 of 0.12 back.
  EXPECT_LT((Link("crossbeam").translation() - Vector3d(0, 1.45 - 0.08, 0.55)).norm(), 1e-9);
  EXPECT_LT((Link("left_hand").translation() - Vector3d(-0.12, 1.45, 0.55)).norm(), 1e-9);
  EXPECT_LT((Link("right_hand").translation() - Vector3d(0.12, 1.45, 0.55)).norm(), 1e-9);
}

TEST_F(Kinematics, EachHandFollowsItsOwnOpening) {
  SetArm(0, 180, 0);
  state_.left_opening = 0.03;  // stopped by what it touches
  state_.right_opening = 0.09;
  state_.joint[kGripperOpening] = 0.06;
  EXPECT_NEAR(Link("left_hand").translation().x(), -0.03, 1e-12);
  EXPECT_NEAR(Link("right_hand").translation().x(), 0.09, 1e-12);
  EXPECT_NEAR(Link("crossbeam").translation().y(), 1.45 - 0.04, 1e-9);
}

TEST_F(Kinematics, OpeningAndClosingComesBackExactly) {
  LinkPoses(robot_, state_, X_WL_);
  const std::vector<Eigen::Isometry3d> before = X_WL_;
  state_.joint[kGripperOpening] = state_.left_opening = state_.right_opening = 0.12;
  LinkPoses(robot_, state_, X_WL_);
  state_.joint[kGripperOpening] = state_.left_opening = state_.right_opening = 0;
  LinkPoses(robot_, state_, X_WL_);
  for (size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(X_WL_[i].matrix(), before[i].matrix()) << robot_.links[i].name;
  }
}

TEST_F(Kinematics, CounterClockwiseRotationLiftsTheRightHand) {
  SetArm(0, 180, 0);
  state_.joint[kGripperRoll] = 90 * kDegree;
  state_.right_opening = 0.1;
  // Seen from behind: right turns up, so the right pad stands above the middle.
  EXPECT_NEAR(Link("right_hand").translation().z(), 0.55 + 0.1, 1e-9);
}

TEST_F(Kinematics, CameraPansLeftAndTiltsUp) {
  state_.joint[kCameraPan] = 90 * kDegree;
  state_.joint[kCameraTilt] = 30 * kDegree;
  const Attitude attitude = ToAttitude(Link("camera_tilt").linear());
  EXPECT_NEAR(attitude.heading, 90 * kDegree, 1e-9);
  EXPECT_NEAR(attitude.pitch, 30 * kDegree, 1e-9);
}

TEST_F(Kinematics, PosesKeepTheirMemory) {
  LinkPoses(robot_, state_, X_WL_);
  const auto* memory = X_WL_.data();
  LinkPoses(robot_, state_, X_WL_);
  EXPECT_EQ(X_WL_.data(), memory);
}

}  // namespace
}  // namespace eod::sim
