#include "sim/simulator.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/behaviour/operator.h"

namespace eod::sim {
namespace {

using std::chrono::milliseconds;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// The wall's near face; front small wheels with level flippers are 0.775 ahead of the origin.
constexpr double kWallY = 4.0;
constexpr double kWheelY = 0.775;
constexpr double kD0 = 0.12;
constexpr double kLow = 0.30;  // [m/s]
constexpr double kStep = 0.004;
constexpr uint32_t kFrontWheels = 0b11;
constexpr uint32_t kChassisPart = 1u << static_cast<int>(Part::kChassis);

TEST(Simulator, StandsOnThePadAtTheStart) {
  Operator op;
  const StepResult& result = op.Step();
  EXPECT_EQ(result.step, 1);
  EXPECT_EQ(result.time, TimePoint(milliseconds(4)));
  EXPECT_EQ(result.module, 1);
  EXPECT_LT(result.state.position.norm(), 1e-9);
  EXPECT_NEAR(result.state.attitude.pitch, 0, 1e-9);
  EXPECT_EQ(result.inhibited, 0u);
  EXPECT_EQ(result.inhibit_reason, kReasonNone);
  EXPECT_THAT(result.alarm_changes, IsEmpty());
}

TEST(Simulator, WallStopsTheWheelsWithinTheirGapAndRaisesTheAlarmInThatStep) {
  Operator op;
  op.LevelFlippers();
  const StepResult contact = op.DriveIntoContact();
  const double gap = kWallY - (contact.state.position.y() + kWheelY);
  EXPECT_GT(gap, kD0 - kLow * kStep);
  EXPECT_LE(gap, kD0);
  EXPECT_EQ(contact.speed, 0);
  EXPECT_EQ(contact.inhibited, SetOf(kDriveForward));
  EXPECT_EQ(contact.inhibit_reason, kReasonCollision);
  EXPECT_EQ(contact.contact_parts, kFrontWheels);
  EXPECT_THAT(contact.alarm_changes,
              ElementsAre(AlarmChange{AlarmCode::kCollision, true, kFrontWheels}));
  // Pushing on moves nothing.
  EXPECT_EQ(op.Step().state, contact.state);
}

TEST(Simulator, UprightFlippersLeaveTheStopToTheChassis) {
  Operator op;
  const StepResult& contact = op.DriveIntoContact();
  EXPECT_EQ(contact.contact_parts, kChassisPart);
  // Chassis front 0.475 ahead of the origin, its lines begin there and have D0 = 0.05.
  const double gap = kWallY - (contact.state.position.y() + 0.475);
  EXPECT_GT(gap, 0.05 - kLow * kStep);
  EXPECT_LE(gap, 0.05);
}

TEST(Simulator, RetreatIsFreeAtOnceAndEndsTheAlarm) {
  Operator op;
  op.LevelFlippers();
  op.DriveIntoContact();
  const double stopped_at = op.state().position.y();
  op.Press({});
  for (int i = 0; i < 50; ++i) EXPECT_EQ(op.Step().inhibited, SetOf(kDriveForward));
  op.Press({kDriveReverse});
  EXPECT_NEAR(op.Step().state.position.y(), stopped_at - kLow * kStep, 1e-9);
  EXPECT_EQ(op.dut.last().speed, -kLow);
  // Less than a step beyond D0: the way is found free again after the second step at the latest.
  std::vector<AlarmChange> changes = op.dut.last().alarm_changes;
  for (int i = 0; i < 2; ++i) {
    const auto& more = op.Step().alarm_changes;
    changes.insert(changes.end(), more.begin(), more.end());
  }
  EXPECT_THAT(changes, ElementsAre(AlarmChange{AlarmCode::kCollision, false, kFrontWheels}));
  EXPECT_EQ(op.dut.last().inhibited, 0u);
  EXPECT_EQ(op.dut.last().contact_parts, 0u);
}

TEST(Simulator, TurnsBesideTheWallOnlyWithRoomToSwing) {
  Operator op;
  op.LevelFlippers();
  op.DriveIntoContact();
  op.Press({kTurnLeft});  // would swing the right wheel into the wall
  EXPECT_TRUE(Contains(op.Step().inhibited, kTurnLeft));
  EXPECT_EQ(op.dut.last().turn_rate, 0);
  op.Hold({kDriveReverse}, 500);
  op.Hold({kTurnLeft}, 750);
  EXPECT_NEAR(op.state().attitude.heading, 90 * kDegree, 1e-9);
}

TEST(Simulator, PushingOnRaisesTheSecondAlarm) {
  Operator op;
  op.LevelFlippers();
  op.DriveIntoContact();
  for (int i = 0; i < 250; ++i) EXPECT_THAT(op.Step().alarm_changes, IsEmpty());
  EXPECT_THAT(op.Step().alarm_changes,
              ElementsAre(AlarmChange{AlarmCode::kPushAfterAlarm, true, kFrontWheels}));
  EXPECT_EQ(op.dut.alarms().active()[0].code, AlarmCode::kPushAfterAlarm);
}

TEST(Simulator, JointLimitInhibitsWhilePressedAndAlarmsOnce) {
  Operator op;
  op.Press({kFrontFlipperUp});  // 90 -> 120 deg at 0.08 deg a step: 375 steps
  int raised = 0;
  for (int i = 0; i < 500; ++i) {
    for (const AlarmChange& change : op.Step().alarm_changes) {
      EXPECT_EQ(change.code, AlarmCode::kJointLimit);
      ++raised;
    }
  }
  EXPECT_EQ(raised, 1);
  EXPECT_EQ(op.dut.last().inhibited, SetOf(kFrontFlipperUp));
  EXPECT_EQ(op.dut.last().inhibit_reason, kReasonJointLimit);
  EXPECT_TRUE(op.dut.last().limit_flags & 1u << kFrontFlipper);
  op.Press({});
  EXPECT_EQ(op.Step().inhibited, 0u);
  op.Press({kFrontFlipperDown});
  op.Step();
  EXPECT_FALSE(op.dut.alarms().IsActive(AlarmCode::kJointLimit));
}

TEST(Simulator, EveryMotionMovesAndItsOppositeReturns) {
  for (int motion = 0; motion < kMotionCount; motion += 2) {
    Operator op;
    op.Hold({kGripperOpen}, 300);  // so that every joint may go either way
    const RobotState start = op.state();
    op.Hold({motion}, 100, 0.5);
    const RobotState there = op.state();
    op.Hold({motion ^ 1}, 100, 0.5);
    const RobotState& back = op.state();
    EXPECT_FALSE(there == start) << "M" << motion + 1;
    EXPECT_LT((back.position - start.position).norm(), 1e-9) << "M" << motion + 1;
    EXPECT_NEAR(std::remainder(back.attitude.heading, 2 * std::numbers::pi), 0, 1e-9);
    for (int j = 0; j < kJointCount; ++j) EXPECT_NEAR(back.joint[j], start.joint[j], 1e-9);
    EXPECT_THAT(op.dut.alarms().active(), IsEmpty()) << "M" << motion + 1;
  }
}

TEST(Simulator, FlipperLoweredOnTheGroundStopsAtTheGoldenAngle) {
  Operator op;
  op.Press({kFrontFlipperDown});
  while (op.Step().contact_parts == 0) {
  }
  const double stopped = op.state().joint[kFrontFlipper];
  op.Hold({kFrontFlipperDown}, 100);  // short of pressing on until it bears
  EXPECT_EQ(op.state().joint[kFrontFlipper], stopped);
  EXPECT_LE(op.state().joint[kFrontFlipper] / kDegree, -14.21 + 0.005);
  EXPECT_GT(op.state().joint[kFrontFlipper] / kDegree, -14.21 - 0.08 - 0.005);
  EXPECT_EQ(op.dut.last().contact_parts, kFrontWheels);
}

TEST(Simulator, ArmLoweredOntoTheGroundStopsAboveIt) {
  Operator op;
  // Far out and down: big arm to its lower limit, elbow stretched, wrist down, fingers open and
  // rolled.
  op.Hold({kSmallArmUp, kGripperOpen}, 2500);
  op.Hold({kBigArmDown, kWristDown, kGripperCw}, 4000);
  op.Hold({kWristUp}, 500);
  op.Hold({kBigArmDown, kSmallArmDown}, 2000);
  EXPECT_TRUE(op.dut.alarms().IsActive(AlarmCode::kCollision));
  std::vector<Eigen::Isometry3d> X_ML;
  LinkPoses(TheRobot(), op.state(), X_ML);
  for (const char* hand : {"left_hand", "right_hand"}) {
    const Eigen::Vector3d tip = X_ML[FindLink(TheRobot(), hand)] * Eigen::Vector3d(0, 0.16, 0);
    EXPECT_GT(tip.z(), 0) << hand;
  }
  EXPECT_LT(op.state().position.norm(), 1e-9);
}

TEST(Simulator, CommandTimeOutMeansZeroMotionAt100Milliseconds) {
  Operator op;
  op.Press({kDriveForward});
  op.Step();
  // No fresh command any more: at 96 ms of age it still drives, at 100 ms it stands.
  TimePoint now = op.now;
  for (int i = 1; i <= 24; ++i) {
    now += milliseconds(4);
    EXPECT_EQ(op.dut.Step(now, op.command).speed, kLow) << i;
  }
  const RobotState before = op.state();
  const StepResult& stopped = op.dut.Step(now + milliseconds(4), op.command);
  EXPECT_EQ(stopped.speed, 0);
  EXPECT_EQ(stopped.state, before);
  EXPECT_EQ(stopped.inhibited, SetOf(kDriveForward));
  EXPECT_EQ(stopped.inhibit_reason, kReasonLinkLoss);
}

TEST(Simulator, DoubtfulCommandsMoveNothing) {
  Operator op;
  const RobotState start = op.Step().state;
  op.command.motion_permitted = false;
  op.Hold({kDriveForward, kBigArmDown}, 10);
  op.command.motion_permitted = true;
  op.Hold({kDriveForward}, 10, std::numeric_limits<double>::quiet_NaN());
  op.Hold({kDriveForward}, 10, -1);
  op.command.speed_range = 3;
  op.Hold({kDriveForward}, 10);
  op.command.speed_range = 1;
  op.Press({kTurnLeft, kTurnRight});
  EXPECT_EQ(op.Step().inhibit_reason, kReasonConflict);
  EXPECT_EQ(op.dut.last().inhibited, SetOf(kTurnLeft) | SetOf(kTurnRight));
  EXPECT_EQ(op.state(), start);
  // More than everything is everything.
  op.Press({kDriveForward}, 7);
  EXPECT_EQ(op.Step().speed, kLow);
}

TEST(Simulator, TheBridgesRefusalIsPassedOn) {
  Operator op;
  op.command.inhibited = SetOf(kBigArmUp);
  op.command.inhibit_reason = 9;
  EXPECT_EQ(op.Step().inhibited, SetOf(kBigArmUp));
  EXPECT_EQ(op.dut.last().inhibit_reason, 9);
}

TEST(Simulator, WholeMissionEndsInSuccessAndPasses) {
  Operator op;
  op.Step();
  EXPECT_EQ(op.dut.last().task.state, MissionState::kIdle);
  op.command.menu_module = 1;
  op.command.menu_command = kMenuStart;
  EXPECT_EQ(op.Step().task.state, MissionState::kRun);
  op.LevelFlippers();
  op.DriveIntoContact();
  EXPECT_EQ(op.dut.last().task.step, 1);
  // Back to y = 1.9, where the way through the gate lies.
  op.Hold({kDriveReverse}, static_cast<int>((op.state().position.y() - 1.9) / (kLow * kStep)));
  EXPECT_EQ(op.dut.last().task.step, 2);
  op.Hold({kTurnLeft}, 750);
  // Wheels reach 0.875 ahead: 0.30 m before the board at x = -8 the origin is at -6.825.
  op.Hold({kDriveForward}, static_cast<int>(6.825 / (kLow * kStep)));
  EXPECT_EQ(op.dut.last().task.step, 3);
  op.Hold({}, 260);
  EXPECT_EQ(op.dut.last().task.state, MissionState::kSuccess);
  const ScoreSheet sheet = op.dut.scorer().Sheet();
  EXPECT_TRUE(sheet.passed);
  EXPECT_EQ(op.dut.last().task.score, sheet.total);
  EXPECT_EQ(sheet.parts[0].points, sheet.parts[0].of);
  EXPECT_EQ(op.dut.last().task.collisions, 1);
}

TEST(Simulator, MenuStartReturnsToThePadAndPauseHoldsEverything) {
  Operator op;
  op.Hold({kDriveForward, kTurnLeft}, 500);
  op.command.menu_module = 1;
  op.command.menu_command = kMenuStart;
  op.Step();
  EXPECT_LT(op.state().position.norm(), 1e-9);
  op.command.menu_command = kMenuPause;
  op.Step();
  const RobotState paused = op.state();
  const double elapsed = op.dut.last().task.elapsed_s;
  op.Hold({kDriveForward}, 100);
  EXPECT_EQ(op.state(), paused);
  EXPECT_EQ(op.dut.last().task.elapsed_s, elapsed);
  op.command.menu_command = kMenuResume;
  op.Hold({kDriveForward}, 100);
  EXPECT_GT(op.state().position.y(), 0.1);
  op.command.menu_command = kMenuEnd;
  EXPECT_EQ(op.Step().task.state, MissionState::kAbort);
}

TEST(Simulator, MissionMayStartWithoutTheMenu) {
  Operator op({.start_mission = true});
  EXPECT_EQ(op.Step().task.state, MissionState::kRun);
  EXPECT_TRUE(op.dut.last().task_changed);
  EXPECT_FALSE(op.Step().task_changed);
}

TEST(Simulator, ConfigurationThatDoesNotFitIsRefused) {
  const auto error_of = [](const Scenario& scenario, Duration period) -> std::string {
    try {
      Simulator(TheRobot(), TheWorld(), scenario, WithRules({.period = period}));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(error_of(FirstDrive(), milliseconds(21)), HasSubstr("21 ms, allowed 1 .. 20 ms"));
  Scenario elsewhere = FirstDrive();
  elsewhere.module = 6;
  EXPECT_THAT(error_of(elsewhere, milliseconds(4)), HasSubstr("module 6 is not in "));
}

}  // namespace
}  // namespace eod::sim
