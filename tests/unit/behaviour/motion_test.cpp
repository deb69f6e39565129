#include "sim/motion/motion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/behaviour/fixture.h"

namespace eod::sim {
namespace {

constexpr double kStep = 0.004;  // [s]

RobotState After(RobotState state, const MotionDemand& demand, int steps) {
  for (int i = 0; i < steps; ++i) state = Advance(TheRobot(), state, demand, kStep);
  return state;
}

TEST(Motion, StraightLineIsExact) {
  RobotState state = HomeState(TheRobot());
  double y = 0;
  for (int i = 0; i < 1000; ++i) {
    state = Advance(TheRobot(), state, DemandFor({kDriveForward}, 0.5), kStep);
    y += 0.5 * 0.30 * kStep;  // half of the low range
  }
  EXPECT_EQ(state.position, Eigen::Vector3d(0, y, 0));
}

TEST(Motion, ForwardAtHeading90GoesWest) {
  RobotState state = HomeState(TheRobot());
  state.attitude.heading = 90 * kDegree;
  state = Advance(TheRobot(), state, DemandFor({kDriveForward}, 1, 2), 0.01);
  EXPECT_NEAR(state.position.x(), -0.0067, 1e-15);
  EXPECT_NEAR(state.position.y(), 0, 1e-15);
}

TEST(Motion, CircleOfNStepsReturnsToItsStart) {
  // 30 deg/s and 4 ms: 0.12 deg a step, 3000 steps a turn.
  const RobotState start = HomeState(TheRobot());
  const RobotState end = After(start, DemandFor({kDriveForward, kTurnLeft}), 3000);
  EXPECT_LT((end.position - start.position).norm(), 1e-9);
  EXPECT_NEAR(std::remainder(end.attitude.heading, 2 * std::numbers::pi), 0, 1e-9);
}

TEST(Motion, ClimbGainsTheSineOfThePitch) {
  RobotState state = HomeState(TheRobot());
  state.attitude.pitch = 20 * kDegree;
  const double d = 0.30 * kStep;
  state = Advance(TheRobot(), state, DemandFor({kDriveForward}), kStep);
  EXPECT_NEAR(state.position.z(), d * std::sin(20 * kDegree), 1e-15);
  EXPECT_NEAR(state.position.y(), d * std::cos(20 * kDegree), 1e-15);
}

TEST(Motion, OppositesReturn) {
  const RobotState start = HomeState(TheRobot());
  for (int motion = 0; motion < kMotionCount; motion += 2) {
    if (motion == kGripperOpen) continue;  // closed at home: its own test below
    const RobotState there = After(start, DemandFor({motion}, 0.4), 100);
    const RobotState back = After(there, DemandFor({motion ^ 1}, 0.4), 100);
    EXPECT_FALSE(there == start) << "M" << motion + 1;
    EXPECT_LT((back.position - start.position).norm(), 1e-12) << "M" << motion + 1;
    EXPECT_NEAR(std::remainder(back.attitude.heading, 2 * std::numbers::pi), 0, 1e-12);
    for (int j = 0; j < kJointCount; ++j) {
      EXPECT_NEAR(back.joint[j], start.joint[j], 1e-12) << "M" << motion + 1 << " J" << j + 1;
    }
  }
}

TEST(Motion, EachJointMotionMovesItsJointAtItsRate) {
  // Table of the robot: degrees a second of J1 .. J9; J7 0.27 units of 0.15 m.
  const std::array<double, kJointCount> rate = {20 * kDegree, 20 * kDegree, 10 * kDegree,
                                                15 * kDegree, 20 * kDegree, 30 * kDegree,
                                                0.0405,       40 * kDegree, 30 * kDegree};
  RobotState middle = HomeState(TheRobot());
  for (int j = 0; j < kJointCount; ++j) {
    middle.joint[j] = (TheRobot().joints[j].lower + TheRobot().joints[j].upper) / 2;
  }
  middle.left_opening = middle.right_opening = middle.joint[kGripperOpening];
  for (int motion = kFrontFlipperUp; motion < kMotionCount; ++motion) {
    const int joint = (motion - kFrontFlipperUp) / 2;
    const double sign = motion % 2 == 0 ? 1 : -1;
    const RobotState moved = After(middle, DemandFor({motion}), 1);
    for (int j = 0; j < kJointCount; ++j) {
      const double change = j == joint ? sign * rate[j] * kStep : 0;
      EXPECT_NEAR(moved.joint[j] - middle.joint[j], change, 1e-12)
          << "M" << motion + 1 << " J" << j + 1;
    }
    EXPECT_EQ(moved.position, middle.position);
  }
}

TEST(Motion, JointsStopAtTheirLimitsExactly) {
  const RobotState home = HomeState(TheRobot());
  // Front flipper 90 -> 120 deg at 20 deg/s takes 375 steps; big arm 120 -> 0 deg at 10 deg/s 3000.
  const RobotState up = After(home, DemandFor({kFrontFlipperUp}), 400);
  EXPECT_EQ(up.joint[kFrontFlipper], TheRobot().joints[kFrontFlipper].upper);
  EXPECT_TRUE(Contains(LimitedMotions(TheRobot(), up), kFrontFlipperUp));
  EXPECT_FALSE(Contains(LimitedMotions(TheRobot(), up), kFrontFlipperDown));
  EXPECT_EQ(LimitFlags(TheRobot(), up) & 1u << kFrontFlipper, 1u << kFrontFlipper);
  const RobotState down = After(home, DemandFor({kBigArmDown}), 3100);
  EXPECT_EQ(down.joint[kBigArm], 0);
  EXPECT_TRUE(Contains(LimitedMotions(TheRobot(), down), kBigArmDown));
}

TEST(Motion, GripperRotationWrapsAndHasNoLimit) {
  // 30 deg/s: 1500 steps of 0.12 deg are 180 deg, the next one shows as -179.88.
  const RobotState home = HomeState(TheRobot());
  const RobotState turned = After(home, DemandFor({kGripperCcw}), 1501);
  EXPECT_NEAR(turned.joint[kGripperRoll] / kDegree, -179.88, 1e-9);
  const RobotState full = After(home, DemandFor({kGripperCcw}), 3000);
  EXPECT_NEAR(full.joint[kGripperRoll], 0, 1e-9);
  RobotState at_pi = home;
  at_pi.joint[kGripperRoll] = std::numbers::pi;
  EXPECT_EQ(LimitFlags(TheRobot(), at_pi) & 1u << kGripperRoll, 0u);
}

TEST(Motion, OpenAndCloseReturnsExactlyAndTheBeamRetracts80Millimetres) {
  const RobotModel& robot = TheRobot();
  const int beam = FindLink(robot, "crossbeam");
  const int gripper = FindLink(robot, "gripper");
  std::vector<Eigen::Isometry3d> X_ML;
  const auto beam_y = [&](const RobotState& state) {
    LinkPoses(robot, state, X_ML);
    return (X_ML[gripper].inverse() * X_ML[beam].translation()).y();
  };
  const RobotState closed = HomeState(robot);
  // 120 mm a hand at 40.5 mm/s: 741 steps.
  const RobotState open = After(closed, DemandFor({kGripperOpen}), 800);
  EXPECT_EQ(open.left_opening, robot.joints[kGripperOpening].upper);
  EXPECT_EQ(open.right_opening, robot.joints[kGripperOpening].upper);
  // Eq. 6: two thirds of the mean opening, towards the wrist.
  EXPECT_NEAR(beam_y(open) - beam_y(closed), -0.080, 1e-9);
  EXPECT_EQ(After(open, DemandFor({kGripperClose}), 800), closed);
}

TEST(Motion, AStoppedHandStandsWhileTheOtherMovesOn) {
  RobotState state = HomeState(TheRobot());
  state.left_opening = state.right_opening = state.joint[kGripperOpening] = 0.06;
  MotionDemand demand = DemandFor({kGripperClose});
  demand.left_hand_stopped = true;
  const RobotState next = Advance(TheRobot(), state, demand, kStep);
  const double d = 0.0405 * kStep;
  EXPECT_EQ(next.left_opening, 0.06);
  EXPECT_NEAR(next.right_opening, 0.06 - d, 1e-15);
  EXPECT_NEAR(next.joint[kGripperOpening], 0.06 - d / 2, 1e-15);
}

TEST(PointVelocity, IsWhatAdvanceDoesToThePoint) {
  const RobotModel& robot = TheRobot();
  RobotState state = HomeState(robot);
  state.position = {3, -2, 0.5};
  state.attitude = {.heading = 0.7, .pitch = 0.2, .roll = -0.1};
  state.joint = {0.3, -0.2, 1.0, 1.2, 0.4, 0.5, 0.06, 0.3, -0.2};
  state.left_opening = 0.05;
  state.right_opening = 0.07;
  constexpr double kTiny = 1e-6;  // [s]
  std::vector<Eigen::Isometry3d> before, after;
  LinkPoses(robot, state, before);
  for (int motion = 0; motion < kMotionCount; ++motion) {
    const MotionDemand demand = DemandFor({motion});
    LinkPoses(robot, Advance(robot, state, demand, kTiny), after);
    for (int link = 0; link < static_cast<int>(robot.links.size()); ++link) {
      const Eigen::Vector3d p_L(0.1, 0.3, -0.05);
      const Eigen::Vector3d p_M = before[link] * p_L;
      const Eigen::Vector3d moved = (after[link] * p_L - p_M) / kTiny;
      const Eigen::Vector3d v_M = PointVelocity(robot, state, before, link, p_M, motion,
                                                RatedSpeed(robot, motion, demand.speed_range));
      EXPECT_LT((moved - v_M).norm(), 1e-6)
          << "M" << motion + 1 << " " << robot.links[link].name << " " << v_M.transpose();
    }
  }
}

}  // namespace
}  // namespace eod::sim
