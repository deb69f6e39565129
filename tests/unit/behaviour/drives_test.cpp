#include "sim/motion/drives.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/behaviour/fixture.h"

namespace eod::sim {
namespace {

constexpr double kStep = 0.004;

/// Steps until the rate of `motion` no longer changes under `wanted`.
int StepsToSettle(Drives& dut, const MotionDemand& wanted, int motion) {
  double last = -1;
  for (int steps = 0; steps < 10000; ++steps) {
    const double rate = dut.Follow(wanted, kStep).rate[motion];
    if (rate == last) return steps;
    last = rate;
  }
  return -1;
}

TEST(Drives, ComeUpToSpeedByTheAccelerationOfTheRobotFile) {
  const RobotModel& robot = TheRobot();
  Drives dut(robot);
  const MotionDemand wanted = DemandFor({kDriveForward}, 1, 2);
  const double first = dut.Follow(wanted, kStep).rate[kDriveForward];
  EXPECT_DOUBLE_EQ(first * robot.drive_speed[2], robot.drive_acceleration * kStep);
  const int expected =
      static_cast<int>(std::ceil(robot.drive_speed[2] / robot.drive_acceleration / kStep));
  EXPECT_NEAR(StepsToSettle(dut, wanted, kDriveForward), expected, 1);
  EXPECT_EQ(dut.Follow(wanted, kStep).rate[kDriveForward], 1.0);
}

TEST(Drives, HeldForATimeCoverRateTimesTimeWithTheirRunOut) {
  const RobotModel& robot = TheRobot();
  for (const int motion : {kDriveForward, kTurnRight, kBigArmDown, kGripperOpen}) {
    Drives dut(robot);
    const int held = 250;
    double covered = 0;
    for (int i = 0; i < 4 * held; ++i) {
      const MotionDemand wanted = i < held ? DemandFor({motion}) : DemandFor({});
      covered += dut.Follow(wanted, kStep).rate[motion] * RatedSpeed(robot, motion, 1) * kStep;
    }
    EXPECT_NEAR(covered, RatedSpeed(robot, motion, 1) * held * kStep, 1e-9) << motion;
  }
}

TEST(Drives, StandAtOnceWhenHalted) {
  Drives dut(TheRobot());
  const MotionDemand wanted = DemandFor({kDriveForward, kBigArmUp});
  for (int i = 0; i < 200; ++i) dut.Follow(wanted, kStep);
  dut.Halt(SetOf(kDriveForward));
  const MotionDemand next = dut.Follow(DemandFor({}), kStep);
  EXPECT_EQ(next.rate[kDriveForward], 0.0);
  EXPECT_GT(next.rate[kBigArmUp], 0.0);
  dut.HaltAll();
  EXPECT_EQ(dut.Follow(DemandFor({}), kStep).commanded, 0u);
}

TEST(Drives, ReversalPassesThroughAStand) {
  Drives dut(TheRobot());
  for (int i = 0; i < 200; ++i) dut.Follow(DemandFor({kDriveForward}), kStep);
  bool has_stood = false;
  for (int i = 0; i < 400; ++i) {
    const MotionDemand next = dut.Follow(DemandFor({kDriveReverse}), kStep);
    EXPECT_FALSE(next.rate[kDriveForward] > 0 && next.rate[kDriveReverse] > 0);
    has_stood = has_stood || std::max(next.rate[kDriveForward], next.rate[kDriveReverse]) < 0.02;
  }
  EXPECT_TRUE(has_stood);
  EXPECT_EQ(dut.Follow(DemandFor({kDriveReverse}), kStep).rate[kDriveReverse], 1.0);
}

TEST(Drives, LowerSpeedRangeIsReachedByTheSameDeceleration) {
  const RobotModel& robot = TheRobot();
  Drives dut(robot);
  for (int i = 0; i < 300; ++i) dut.Follow(DemandFor({kDriveForward}, 1, 2), kStep);
  double last = robot.drive_speed[2];
  for (int i = 0; i < 300; ++i) {
    const double speed = dut.Follow(DemandFor({kDriveForward}, 1, 0), kStep).rate[kDriveForward] *
                         robot.drive_speed[0];
    EXPECT_LE(last - speed, robot.drive_acceleration * kStep + 1e-12);
    last = speed;
  }
  EXPECT_DOUBLE_EQ(last, robot.drive_speed[0]);
}

TEST(Drives, FollowARampToZeroAtOnceWhenTheyBrake) {
  Drives dut(TheRobot());
  for (int i = 0; i < 300; ++i) dut.Follow(DemandFor({kDriveForward}, 1, 2), kStep);
  EXPECT_EQ(dut.Follow(DemandFor({kDriveForward}, 0.3, 2), kStep, true).rate[kDriveForward], 0.3);
  EXPECT_EQ(dut.Follow(DemandFor({}, 0, 2), kStep, true).commanded, 0u);
}

}  // namespace
}  // namespace eod::sim
