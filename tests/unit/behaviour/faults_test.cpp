#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/battery/battery.h"
#include "sim/faults/fault_injector.h"
#include "sim/faults/faulty_motion.h"
#include "tests/unit/behaviour/fixture.h"

namespace eod::sim {
namespace {

using Kind = FaultSpec::Kind;
constexpr double kStep = 0.004;  // [s]

Scenario Broken(std::vector<FaultSpec> faults) {
  Scenario scenario;
  scenario.file = "exercise.toml";
  scenario.steps.resize(3);
  scenario.faults = std::move(faults);
  return scenario;
}

/// What is broken by one fault that begins at once.
ActiveFaults With(FaultSpec fault) {
  fault.at = 0;
  FaultInjector dut(Broken({fault}), TheRobot());
  dut.Advance({.dt_s = kStep, .running = true});
  return dut.active();
}

TEST(FaultInjector, BeginsAtItsMomentOfTheMissionAndEndsAfterItsTime) {
  FaultInjector dut(Broken({{.kind = Kind::kRadioLoss, .at = 2.0, .duration = 3.0}}), TheRobot());
  std::vector<std::pair<int, bool>> changes;
  for (int step = 0; step < 3000; ++step) {
    dut.Advance({.dt_s = kStep, .running = true, .elapsed_s = step * kStep});
    for (const FaultChange& change : dut.changes()) changes.emplace_back(step, change.begins);
    EXPECT_EQ(dut.active().silent, step >= 500 && step < 1250);
  }
  const std::vector<std::pair<int, bool>> expected = {{500, true}, {1250, false}};
  EXPECT_EQ(changes, expected);
}

TEST(FaultInjector, WaitsForTheMission) {
  FaultInjector dut(Broken({{.kind = Kind::kFieldEstop, .at = 0.0}}), TheRobot());
  dut.Advance({.dt_s = kStep, .elapsed_s = 10});
  EXPECT_FALSE(dut.active().field_estop);
  dut.Advance({.dt_s = kStep, .running = true});
  EXPECT_TRUE(dut.active().field_estop);
  dut.Reset();
  EXPECT_EQ(dut.active(), ActiveFaults{});
}

TEST(FaultInjector, BeginsAfterAStepOrOnAGraspAndOnceAMission) {
  FaultInjector dut(Broken({{.kind = Kind::kGripperSlip, .on_grasp = true, .duration = kStep},
                            {.kind = Kind::kBatterySag, .amount = 2, .after_step = 2}}),
                    TheRobot());
  dut.Advance({.dt_s = kStep, .running = true, .steps_done = 1});
  EXPECT_EQ(dut.active(), ActiveFaults{});
  dut.Advance({.dt_s = kStep, .running = true, .steps_done = 2, .holds_charge = true});
  EXPECT_TRUE(dut.active().gripper_slips);
  EXPECT_EQ(dut.active().battery_sag, 2);
  for (int i = 0; i < 3; ++i) {
    dut.Advance({.dt_s = kStep, .running = true, .steps_done = 2, .holds_charge = true});
    EXPECT_FALSE(dut.active().gripper_slips);
    EXPECT_EQ(dut.active().battery_sag, 2);
  }
}

TEST(FaultInjector, EachKindBreaksItsThing) {
  const auto camera = [](Kind kind) { return With({.kind = kind, .target = "gripper"}).camera; };
  size_t gripper = 0;
  while (TheRobot().cameras[gripper].name != "gripper") ++gripper;
  EXPECT_EQ(camera(Kind::kCameraDead)[gripper], kCameraDeadBit);
  EXPECT_EQ(camera(Kind::kCameraFrozen)[gripper], kCameraFrozenBit);
  EXPECT_EQ(camera(Kind::kCameraNoisy)[gripper], kCameraNoisyBit);
  EXPECT_EQ(camera(Kind::kCameraWrongLight)[gripper], kCameraWrongLightBit);
  EXPECT_EQ(With({.kind = Kind::kJointStuck, .target = "J3"}).stuck_joints, 1u << kBigArm);
  EXPECT_EQ(With({.kind = Kind::kJointSlow, .target = "J5", .amount = 0.5}).joint_share[kWrist],
            0.5);
  EXPECT_DOUBLE_EQ(
      With({.kind = Kind::kJointDrift, .target = "J4", .amount = -2}).joint_drift[kSmallArm],
      -2 * kDegree);
  EXPECT_DOUBLE_EQ(
      With({.kind = Kind::kJointDrift, .target = "J7", .amount = 3}).joint_drift[kGripperOpening],
      0.003);
  EXPECT_DOUBLE_EQ(
      With({.kind = Kind::kSensorOffset, .target = "J1", .amount = 5}).joint_offset[kFrontFlipper],
      5 * kDegree);
  EXPECT_EQ(With({.kind = Kind::kTrackWeak, .target = "right", .amount = 0.6}).right_track, 0.6);
  EXPECT_EQ(With({.kind = Kind::kStuckButton, .target = "M01"}).stuck_buttons,
            SetOf(kDriveForward));
  EXPECT_EQ(With({.kind = Kind::kLampBroken, .target = "collision"}).dark_lamps, 1u << 4);
  EXPECT_TRUE(With({.kind = Kind::kRadioLoss}).silent);
}

std::string ErrorOf(FaultSpec fault) {
  fault.at = 0;
  fault.line = 7;
  try {
    FaultInjector(Broken({fault}), TheRobot());
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(FaultInjector, WrongTargetsAreNamedWithFileLineAndTheNearest) {
  EXPECT_EQ(ErrorOf({.kind = Kind::kCameraDead, .target = "griper"}),
            "exercise.toml:7: fault camera_dead: target = 'griper' is unknown; did you mean "
            "'gripper'?");
  EXPECT_EQ(ErrorOf({.kind = Kind::kJointStuck, .target = "J10"}),
            "exercise.toml:7: fault joint_stuck: target = 'J10' is unknown; did you mean 'J1'?");
  EXPECT_EQ(ErrorOf({.kind = Kind::kLampBroken, .target = "colision"}),
            "exercise.toml:7: fault lamp_broken: target = 'colision' is unknown; did you mean "
            "'collision'?");
  EXPECT_EQ(ErrorOf({.kind = Kind::kFieldEstop, .target = "J1"}),
            "exercise.toml:7: fault field_estop: target = 'J1', allowed none");
  EXPECT_EQ(ErrorOf({.kind = Kind::kTrackWeak, .target = "left", .amount = 1.5}),
            "exercise.toml:7: fault track_weak: amount = 1.5, allowed 0 .. 1");
  EXPECT_EQ(ErrorOf({.kind = Kind::kCableSnag}),
            "exercise.toml:7: fault cable_snag: there is no cable: [link] kind = 'cable' is "
            "missing");
  EXPECT_EQ(ErrorOf({.kind = Kind::kRadioLoss, .after_step = 4}),
            "exercise.toml:7: fault radio_loss: after_step = 4, the exercise has 3");
}

TEST(FaultyMotion, StuckSlowAndDriftingJoints) {
  const RobotModel& robot = TheRobot();
  const MotionDemand wanted = DemandFor({kBigArmUp, kWristDown});
  ActiveFaults faults;
  EXPECT_EQ(FaultyMotion(robot, faults, wanted).rate, wanted.rate);
  faults.stuck_joints = 1u << kBigArm;
  faults.joint_share[kWrist] = 0.5;
  faults.joint_drift[kSmallArm] = -2 * kDegree;
  const MotionDemand found = FaultyMotion(robot, faults, wanted);
  EXPECT_EQ(found.rate[kBigArmUp], 0);
  EXPECT_FALSE(Contains(found.commanded, kBigArmUp));
  EXPECT_EQ(found.rate[kWristDown], 0.5);
  const double share = 2 * kDegree / robot.joints[kSmallArm].rate;
  const bool grows_up = robot.joints[kSmallArm].positive_motion == kSmallArmUp;
  EXPECT_DOUBLE_EQ(found.rate[grows_up ? kSmallArmDown : kSmallArmUp], share);
}

TEST(FaultyMotion, WeakTrackPullsTheRobotToItsSideByDifferentialDrive) {
  const RobotModel& robot = TheRobot();
  ActiveFaults faults;
  faults.left_track = 0.8;
  const MotionDemand found = FaultyMotion(robot, faults, DemandFor({kDriveForward}));
  const double v = robot.drive_speed[1];  // low
  EXPECT_NEAR(found.rate[kDriveForward] * v, (0.8 * v + v) / 2, 1e-12);
  EXPECT_NEAR(found.rate[kTurnLeft] * robot.turn_rate, (v - 0.8 * v) / robot.track, 1e-12);
  EXPECT_EQ(found.rate[kTurnRight], 0);
  // Backwards the same side lags, so it turns the other way.
  const MotionDemand back = FaultyMotion(robot, faults, DemandFor({kDriveReverse}));
  EXPECT_NEAR(back.rate[kTurnRight] * robot.turn_rate, 0.2 * v / robot.track, 1e-12);
}

TEST(Battery, VoltageSinksWithLoadAndChargeWithTime) {
  const RobotModel& robot = TheRobot();
  const BatterySpec& spec = robot.battery;
  ASSERT_GT(spec.capacity, 0);
  Battery dut(robot);
  EXPECT_EQ(dut.voltage(), spec.full);
  dut.Advance({}, 0, kStep);
  EXPECT_NEAR(dut.voltage(), spec.full - spec.resistance * spec.idle_current, 1e-6);
  dut.Advance(DemandFor({kDriveForward, kBigArmUp}, 0.5), 0, kStep);
  const double current = spec.idle_current + 0.5 * (spec.drive_current + spec.joint_current);
  EXPECT_DOUBLE_EQ(dut.current(), current);
  EXPECT_NEAR(dut.voltage(), spec.full - spec.resistance * current, 1e-5);
  dut.Reset();
  for (int i = 0; i < 1000; ++i) dut.Advance({}, 0, 3.6);  // an hour
  EXPECT_NEAR(dut.charge(), 1 - 3600 * spec.idle_current / spec.capacity, 1e-9);
  EXPECT_FALSE(dut.is_low());
  dut.Reset();
  dut.Advance({}, spec.full - spec.low, kStep);
  EXPECT_TRUE(dut.is_low());
}

}  // namespace
}  // namespace eod::sim
