#include <gtest/gtest.h>

#include "tests/unit/behaviour/terrain.h"

namespace eod::sim {
namespace {

constexpr double kFoot = 1.5;  // [m] where obstacles begin

/// A step up (or down) to another level.
Terrain Kerb(double height) {
  return Terrain().AddStrip(kGround, {{-5, 0}, {kFoot, 0}, {kFoot, height}, {kFoot + 8, height}});
}

Terrain Gap(double width) {
  Terrain gap;
  gap.AddStrip(kGround, {{-5, 0},
                         {kFoot, 0},
                         {kFoot, -1.5},
                         {kFoot + width, -1.5},
                         {kFoot + width, 0},
                         {kFoot + 8, 0}});
  return gap;
}

/// A round bar across the way, its top at `height`.
Terrain Hurdle(double height) {
  constexpr double kRadius = 0.05;
  Eigen::Isometry3d X_MO = Eigen::Isometry3d::Identity();
  X_MO.translation() = Eigen::Vector3d(0, kFoot, height - kRadius);
  X_MO.linear() = Eigen::AngleAxisd(90 * kDegree, Eigen::Vector3d::UnitY()).toRotationMatrix();
  Terrain hurdle;
  hurdle.AddStrip(kGround, {{-5, 0}, {9, 0}});
  return hurdle.Add(kGround, CylinderMesh(kRadius, 3, 24), X_MO);
}

TEST(Obstacles, KerbIsClimbedAndLeftWithFlippersOut) {
  Driver driver(Kerb(0.15));
  driver.LevelFlippers();
  ASSERT_TRUE(driver.DriveTo(kFoot + 1.5));
  driver.Rest();
  EXPECT_NEAR(driver.state().position.z(), 0.15, 1e-6);
  EXPECT_NEAR(driver.pitch_deg(), 0, 1e-6);
  ASSERT_TRUE(driver.DriveTo(0, kDriveReverse));
  driver.Rest();
  EXPECT_NEAR(driver.state().position.z(), 0, 1e-6);
}

TEST(Obstacles, KerbWithFlippersUprightRearsTheRobotUpUntilTheTiltLimit) {
  Driver driver(Kerb(0.15));
  EXPECT_FALSE(driver.DriveTo(kFoot + 1.5, kDriveForward, 30));
  driver.Press({kDriveForward});
  EXPECT_EQ(driver.Step().inhibit_reason, kReasonTilt);
}

TEST(Obstacles, KerbAsHighAsTheWheelsStopsThem) {
  Driver driver(Kerb(0.25));
  driver.LevelFlippers();
  EXPECT_FALSE(driver.DriveTo(kFoot + 1, kDriveForward, 30));
  EXPECT_EQ(driver.dut.last().contact_parts, 0b11u);
  EXPECT_NEAR(driver.pitch_deg(), 0, 1e-6);
}

class LowHurdle : public ::testing::TestWithParam<double> {};

TEST_P(LowHurdle, IsCrossedInOneGo) {
  Driver driver(Hurdle(GetParam()));
  driver.Flipper(kFrontFlipper, 45);
  driver.Flipper(kRearFlipper, 0);
  EXPECT_TRUE(driver.DriveTo(kFoot + 2));
  driver.Rest();
  EXPECT_NEAR(driver.state().position.z(), 0, 1e-6);
}
INSTANTIATE_TEST_SUITE_P(Obstacles, LowHurdle, ::testing::Values(0.10, 0.20));

TEST(Obstacles, HighestHurdleNeedsRaisedFlippersAndTheRearOnesPressedDown) {
  {
    Driver level(Hurdle(0.40));
    level.LevelFlippers();
    EXPECT_FALSE(level.DriveTo(kFoot + 1, kDriveForward, 30));  // the small wheels stop
    EXPECT_NE(level.dut.last().contact_parts, 0u);
  }
  Driver driver(Hurdle(0.40));
  driver.command.speed_range = 0;
  driver.Flipper(kFrontFlipper, 45);
  driver.Flipper(kRearFlipper, 0);
  EXPECT_FALSE(driver.DriveTo(kFoot + 1, kDriveForward, 30));
  driver.Press({kDriveForward});
  EXPECT_EQ(driver.Step().inhibit_reason, kReasonTilt);
  const double reared_up = driver.pitch_deg();
  driver.Hold({kRearFlipperDown}, 1.5);  // lifts the rear
  EXPECT_LT(driver.pitch_deg(), reared_up - 8);
  EXPECT_TRUE(driver.DriveTo(kFoot + 0.3, kDriveForward, 20));
  driver.Flipper(kFrontFlipper, 0);
  EXPECT_TRUE(driver.DriveTo(kFoot + 2, kDriveForward, 40));
}

TEST(Obstacles, GapIsCrossedIfItIsNarrowerThanTheSupport) {
  // Half the support, with lowered flippers 0.775 m, is more than the trench of 0.64 m.
  for (const double width : {0.40, 0.60, 0.64}) {
    Driver driver(Gap(width));
    driver.LowerFlippers();
    double most = 0;
    driver.watch = [&](const StepResult& result) {
      most = std::max(most, std::abs(result.state.attitude.pitch / kDegree));
    };
    EXPECT_TRUE(driver.DriveTo(kFoot + 3, kDriveForward, 30)) << width;
    EXPECT_LT(most, 1) << width;
    EXPECT_EQ(driver.dut.last().contact_parts, 0u);
  }
}

TEST(Obstacles, NoseTipsIntoAGapThatIsTooWide) {
  Driver driver(Gap(0.90));
  driver.LowerFlippers();
  EXPECT_FALSE(driver.DriveTo(kFoot + 1, kDriveForward, 30));
  EXPECT_LT(driver.pitch_deg(), -5);
  EXPECT_NE(driver.dut.last().contact_parts & 0b11, 0u);  // the wheels meet the far wall
}

TEST(Obstacles, GapThatLoweredFlippersCrossTakesTheNoseOfUprightOnes) {
  Driver driver(Gap(0.64));
  double lowest = 0;
  driver.watch = [&](const StepResult& result) {
    lowest = std::min(lowest, result.state.attitude.pitch / kDegree);
  };
  driver.DriveTo(kFoot + 3, kDriveForward, 30);
  EXPECT_LT(lowest, -10);
}

TEST(Obstacles, StepfieldCarriesTheRobotWithoutJumps) {
  Terrain field;
  field.AddBox({30, 30, 1}, {0, 0, -1});
  uint32_t seed = 7;
  for (int i = -6; i < 6; ++i) {
    for (int j = 0; j < 30; ++j) {
      seed = seed * 1664525 + 1013904223;
      const double height = 0.04 * ((seed >> 16) % 4);
      if (height > 0) field.AddBox({0.1, 0.1, height}, {i * 0.1 + 0.05, kFoot + j * 0.1, 0});
    }
  }
  Driver driver(field);
  driver.Flipper(kFrontFlipper, 30);
  driver.Flipper(kRearFlipper, 0);
  RobotState last = driver.state();
  double most = 0;
  driver.watch = [&](const StepResult& result) {
    most = std::max({most, std::abs(result.state.attitude.pitch - last.attitude.pitch) / kDegree,
                     std::abs(result.state.attitude.roll - last.attitude.roll) / kDegree});
    last = result.state;
  };
  ASSERT_TRUE(driver.DriveTo(kFoot + 1.5));
  EXPECT_GT(std::abs(driver.state().position.z()), 0.01);
  driver.Hold({kTurnLeft}, 2);
  driver.Rest();
  EXPECT_TRUE(driver.state().at_rest);  // however the posts stand
  driver.Hold({kTurnRight}, 2);
  ASSERT_TRUE(driver.DriveTo(kFoot + 5));
  EXPECT_LT(most, 1);
}

TEST(Obstacles, LedgeTipsTheRobotSlowlyAtFirstAndThenAsThingsFall) {
  Driver driver(Kerb(-0.30));
  RobotState last = driver.state();
  double fastest = 0;
  bool smooth = true;
  driver.watch = [&](const StepResult& result) {
    smooth &= result.state.fall_speed - last.fall_speed < 9.80665 * 0.004 + 1e-9;
    fastest = std::max(fastest, result.state.fall_speed);
    last = result.state;
  };
  ASSERT_TRUE(driver.DriveTo(kFoot + 1.2, kDriveForward, 30));
  driver.Rest();
  EXPECT_TRUE(smooth);  // never faster than gravity
  EXPECT_GT(fastest, 0.5);
  EXPECT_NEAR(driver.state().position.z(), -0.30, 1e-6);
}

TEST(Obstacles, RobotThatHangsOnALedgeComesToRest) {
  Driver driver(Kerb(-0.50));
  driver.DriveTo(kFoot + 1, kDriveForward, 10);
  driver.Hold({}, 3);
  EXPECT_LT(driver.pitch_deg(), -30);
  EXPECT_TRUE(driver.state().at_rest);
  const RobotState hangs = driver.state();
  driver.Hold({}, 1);
  EXPECT_EQ(driver.state(), hangs);
}

TEST(Obstacles, NothingBelowIsAFallThatEndsOnTheGroundAndOnTheBack) {
  Driver driver(Kerb(-5));
  driver.DriveTo(kFoot + 3, kDriveForward, 10);
  driver.Rest();
  EXPECT_LT(driver.state().position.z(), -4);
  EXPECT_GT(driver.state().position.z(), -5);
  EXPECT_TRUE(driver.state().rolls_over);
  EXPECT_TRUE(driver.state().at_rest);
  EXPECT_TRUE(driver.dut.alarms().IsActive(AlarmCode::kRollover));
  driver.Press({kDriveReverse});
  EXPECT_EQ(driver.Step().inhibit_reason, kReasonTilt);
}

TEST(Obstacles, RollsOverWhereTheCentreOfGravityLeavesTheTracks) {
  // A ramp under the left track alone: level at first, then as high as a table.
  Terrain ramp;
  ramp.AddStrip(kGround, {{-5, 0}, {12, 0}});
  ramp.AddStrip(kGround, {{kFoot, 0}, {kFoot + 1.2, 0.6}, {kFoot + 5, 0.6}}, -1.5, -0.1);
  RobotModel robot = TheRobot();
  robot.stance.roll_limit = 60 * kDegree;  // as if nothing held the operator back
  robot.stance.pitch_limit = 60 * kDegree;
  const WorldModel world = Driver::WorldOf(ramp);
  Simulator dut(robot, world, {}, WithRules());
  OperatorCommand command;
  command.motion_permitted = true;
  command.motion_rate[kDriveForward] = 1;
  bool alarmed_before_45_deg = false;
  for (int i = 1; i < 5000 && !(dut.last().state.rolls_over && dut.last().state.at_rest); ++i) {
    command.stamp = TimePoint(std::chrono::milliseconds(4 * i));
    const StepResult& result = dut.Step(command.stamp, command);
    const bool alarm = dut.alarms().IsActive(AlarmCode::kRollover);
    alarmed_before_45_deg |= alarm && result.state.attitude.roll < 44 * kDegree;
  }
  EXPECT_TRUE(dut.last().state.rolls_over);
  EXPECT_GT(dut.last().state.attitude.roll, 75 * kDegree);  // on its right side
  EXPECT_TRUE(dut.alarms().IsActive(AlarmCode::kRollover));
  EXPECT_TRUE(alarmed_before_45_deg);
}

TEST(Obstacles, TwoRunsAreEqualToTheLastBit) {
  std::vector<RobotState> first, second;
  for (auto* run : {&first, &second}) {
    Driver driver(Hurdle(0.20));
    driver.watch = [run](const StepResult& result) { run->push_back(result.state); };
    driver.LevelFlippers();
    driver.Hold({kDriveForward, kTurnLeft}, 6);
    driver.Hold({kRearFlipperDown, kBigArmDown}, 4);
    driver.Hold({kDriveForward}, 5);
  }
  EXPECT_EQ(first, second);
}

}  // namespace
}  // namespace eod::sim
