#include <gtest/gtest.h>

#include "tests/unit/behaviour/terrain.h"

namespace eod::sim {
namespace {

constexpr double kFoot = 1.5;  // [m] where obstacles begin

/// A ramp of `length` along the slope, from level ground up to a plateau.
Terrain Ramp(double degrees, double length = 3) {
  const double run = length * std::cos(degrees * kDegree);
  const double rise = length * std::sin(degrees * kDegree);
  return Terrain().AddStrip(kGround,
                            {{-5, 0}, {kFoot, 0}, {kFoot + run, rise}, {kFoot + run + 5, rise}});
}

class Inclined : public ::testing::TestWithParam<double> {};

TEST_P(Inclined, PlaneIsClimbedHeldAndLeftAtItsAngle) {
  Driver driver(Ramp(GetParam()));
  driver.LevelFlippers();
  ASSERT_TRUE(driver.DriveTo(kFoot + 1.5));
  EXPECT_NEAR(driver.pitch_deg(), GetParam(), 1e-6);
  EXPECT_NEAR(driver.roll_deg(), 0, 1e-6);
  const RobotState held = driver.state();
  driver.Hold({}, 2);
  EXPECT_EQ(driver.state(), held);
  ASSERT_TRUE(driver.DriveTo(kFoot + 5));
  driver.Rest();
  EXPECT_NEAR(driver.state().position.z(), 3 * std::sin(GetParam() * kDegree), 1e-6);
  EXPECT_NEAR(driver.pitch_deg(), 0, 1e-6);
  ASSERT_TRUE(driver.DriveTo(0, kDriveReverse));
  driver.Rest();
  EXPECT_NEAR(driver.state().position.z(), 0, 1e-6);
}
INSTANTIATE_TEST_SUITE_P(Slopes, Inclined, ::testing::Values(10, 15, 20, 25, 30, 35));

TEST(Slopes, PlaneBeyondTheLimitIsRefusedForItsTiltAndLeavesTheWayBack) {
  Driver driver(Ramp(42));
  driver.LevelFlippers();
  EXPECT_FALSE(driver.DriveTo(kFoot + 2, kDriveForward, 30));
  driver.Press({kDriveForward});
  driver.Step();
  EXPECT_EQ(driver.dut.last().inhibited, SetOf(kDriveForward));
  EXPECT_EQ(driver.dut.last().inhibit_reason, kReasonTilt);
  EXPECT_NEAR(driver.pitch_deg(), 38, 1);
  EXPECT_TRUE(driver.DriveTo(0, kDriveReverse, 30));
  EXPECT_EQ(driver.dut.last().inhibited, 0u);
}

TEST(Slopes, SlidesDownASlopeBeyondFriction) {
  Driver driver(Terrain().AddSlope(42, 0).StartAt(42, 0));
  driver.Hold({}, 1);
  // The shipped friction is tan 40 deg.
  const double a =
      9.80665 * (std::sin(42 * kDegree) - std::tan(40 * kDegree) * std::cos(42 * kDegree));
  EXPECT_NEAR(driver.state().slip.norm(), a, 0.02 * a);
  EXPECT_LT(driver.state().position.y(), -0.1);
  EXPECT_FALSE(driver.state().at_rest);
}

class SideSlope : public ::testing::TestWithParam<double> {};

TEST_P(SideSlope, IsDrivenAcrossWithoutSlip) {
  Driver driver(Terrain().AddSlope(0, GetParam()).StartAt(0, GetParam()));
  ASSERT_TRUE(driver.DriveTo(2));
  EXPECT_NEAR(driver.roll_deg(), GetParam(), 1e-6);
  EXPECT_NEAR(driver.state().position.x(), 0, 1e-9);
  driver.Hold({kTurnLeft}, 3);  // a quarter: now uphill, its right side was down
  EXPECT_NEAR(driver.pitch_deg(), GetParam(), 1e-6);
  EXPECT_NEAR(driver.roll_deg(), 0, 1e-6);
}
INSTANTIATE_TEST_SUITE_P(Slopes, SideSlope, ::testing::Values(10, 15, 20));

TEST(Slopes, CrossingRampsPitchAndRollTheRobotAndNoPointSinksIn) {
  // Half ramps of 15 deg, 0.6 m long, left and right in turn.
  Terrain field;
  const double rise = 0.6 * std::tan(15 * kDegree);
  for (int i = 0; i < 6; ++i) {
    const double y = kFoot + 0.6 * i;
    const bool left_up = i % 2 == 0;
    field.AddStrip(kGround, {{y, left_up ? 0 : rise}, {y + 0.6, left_up ? rise : 0}}, -1.2, 0);
    field.AddStrip(kGround, {{y, left_up ? rise : 0}, {y + 0.6, left_up ? 0 : rise}}, 0, 1.2);
  }
  field.AddStrip(kGround, {{-5, 0}, {12, 0}});
  Driver driver(field);
  driver.LevelFlippers();
  double most_roll = 0;
  driver.watch = [&](const StepResult& result) {
    most_roll = std::max(most_roll, std::abs(result.state.attitude.roll / kDegree));
    ASSERT_LT(std::abs(result.state.attitude.pitch / kDegree), 25);
    ASSERT_LT(std::abs(result.state.attitude.roll / kDegree), 25);
  };
  ASSERT_TRUE(driver.DriveTo(kFoot + 5));
  EXPECT_GT(most_roll, 5);
  driver.Rest();
  EXPECT_NEAR(driver.state().position.z(), 0, 1e-6);
}

}  // namespace
}  // namespace eod::sim
