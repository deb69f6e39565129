#include <cmath>

#include <gtest/gtest.h>

#include "tests/scenario/terrain_lanes.h"

namespace eod::lockstep {
namespace {

using namespace std::chrono_literals;

struct Ramp {
  double x;
  double angle_deg;
};
class RampDrive : public ::testing::TestWithParam<Ramp> {};

TEST_P(RampDrive, UpAndDownThroughTheBox) {
  const auto [x, angle_deg] = GetParam();
  const double length = 1.5 + 2 * 3 + 2 + 1.5;
  Mission dut = RunMission(
      ToLane(x) +
          fmt::format("speed low\nhold M01 until travel >= {} within 90s\nwait 500ms\n", length),
      "slope_ramps");
  Extremes seen;
  seen.Watch(dut.rig());
  PlayScript(dut, 300s);
  EXPECT_GT(seen.pitch, (angle_deg - 0.1) * kDegree);
  EXPECT_NEAR(seen.z, 3 * std::sin(angle_deg * kDegree), 0.15);
  EXPECT_NEAR(dut.rig().simulator().last().state.position.z(), 0, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Slopes, RampDrive,
                         ::testing::Values(Ramp{4, 10}, Ramp{8, 15}, Ramp{12, 20}, Ramp{16, 25},
                                           Ramp{20, 30}, Ramp{24, 35}),
                         [](const auto& ramp) {
                           return fmt::format("Of{}Degrees", ramp.param.angle_deg);
                         });

class SteepRamp : public ::testing::TestWithParam<const char*> {};

TEST_P(SteepRamp, OfFortyTwoDegreesIsRefusedWithItsReason) {
  Mission dut = RunMission(
      ToLane(28) + fmt::format("speed {}\npress M01\nwait lamp tilt on within 30s\n"
                               "wait reason tilt within 5s\nexpect inhibit M01\nwait 5s\n"
                               "expect reason tilt\nrelease all\nwait 2s\nnote \"back\"\n"
                               "speed low\nhold M02 until travel <= -1.5 within 20s\n"
                               "wait 500ms\nexpect lamp tilt off\n",
                               GetParam()),
      "slope_ramps");
  Extremes seen;
  seen.Watch(dut.rig());
  PlayScript(dut, 300s);
  // It stops while its front climbs, before all of it stands on the plane.
  const double limit = ShippedData().robot.stance.pitch_limit;
  EXPECT_GT(seen.pitch, limit);
  EXPECT_LT(seen.pitch, limit + 0.5 * kDegree);
  EXPECT_LT(seen.z, 0.25 * 3 * std::sin(42 * kDegree));
  EXPECT_NEAR(dut.rig().simulator().last().state.position.z(), 0, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Slopes, SteepRamp, ::testing::Values("creep", "high"),
                         [](const auto& speed) { return std::string(speed.param); });

TEST(Hold, ReleasedStickLeavesItOnTheSlopeToTheLastBit) {
  Mission dut = RunMission(ToLane(12) +
                               "speed low\nmode drive\nstick drive_y 100%\n"
                               "wait pitch >= 19.9 within 30s\nwait 2s\nstick drive_y 0%\n"
                               "wait 11s\nexpect speed <= 0\n",
                           "slope_ramps");
  sim::RobotState stands;
  int64_t since = 0;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    if (step.state == stands) return;
    stands = step.state;
    since = step.step;
  });
  PlayScript(dut, 300s);
  const sim::StepResult& last = dut.rig().simulator().last();
  EXPECT_GE((last.step - since) * 4ms, 10s);
  EXPECT_NEAR(last.state.attitude.pitch, 20 * kDegree, 0.1 * kDegree);
}

/// With the right side up, a robot that drives north rolls to the left.
class SideSlope : public ::testing::TestWithParam<Ramp> {};

TEST_P(SideSlope, RollsTheRobotByItsAngleAndLetsItPass) {
  const auto [x, angle_deg] = GetParam();
  const double way = 1.5 + 8 + 1.5;
  Mission dut = RunMission(
      ToLane(x) + fmt::format("speed low\nhold M01 until travel >= {} within 90s\nwait 500ms\n"
                              "expect lamp tilt off\nexpect lamp collision off\n",
                              way + 0.6),
      "slope_ramps");
  const double slope = -angle_deg * kDegree;
  double left = 0, right = 0, first = 0, last = 0;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    const double roll = step.state.attitude.roll, y = step.state.position.y();
    left = std::min(left, roll);
    right = std::max(right, roll);
    if (std::abs(roll - slope) > 0.1 * kDegree) return;
    if (first == 0) first = y;
    last = y;
  });
  PlayScript(dut, 300s);
  EXPECT_NEAR(left, slope, 0.1 * kDegree);
  EXPECT_LT(right, 0.1 * kDegree);
  // 3 m of it are plane, less what the tracks cover of the ground, 2 x 0.525 m.
  EXPECT_GE(last - first, 3 - 2 * 0.525);
  const sim::RobotState& end = dut.rig().simulator().last().state;
  EXPECT_GT(end.position.y(), 6.5 + way);
  EXPECT_NEAR(end.position.x(), x, 0.2);
  EXPECT_NEAR(end.position.z(), 0, 1e-3);
  EXPECT_NEAR(end.attitude.roll, 0, 0.1 * kDegree);
}

INSTANTIATE_TEST_SUITE_P(Slopes, SideSlope,
                         ::testing::Values(Ramp{32, 10}, Ramp{36, 15}, Ramp{40, 20}),
                         [](const auto& ramp) {
                           return fmt::format("Of{}Degrees", ramp.param.angle_deg);
                         });

TEST(SlopeRamps, CompleteExerciseIsDrivenToSuccess) {
  Mission dut(box::LoadScript(kData / "firmware_emu/scripts/slope_ramps.boxscript"),
              ShippedScenario("slope_ramps"));
  PlayScript(dut, 700s);
  const sim::TaskStatus& task = dut.rig().simulator().last().task;
  EXPECT_EQ(task.state, sim::MissionState::kSuccess);
  EXPECT_EQ(task.step, static_cast<int>(ShippedScenario("slope_ramps").steps.size()));
  EXPECT_LT(task.elapsed_s, ShippedScenario("slope_ramps").par_time_s);
}

/// Drives 3.5 m over the station at x with level flippers pressed to the ground first.
std::string Across(double x) {
  return ToLane(x) +
         "hold M06 M08 until joint 1 <= -14 within 9s\nwait 500ms\nspeed low\n"
         "hold M01 until travel >= 3.5 within 30s\nwait 1s\n";
}

TEST(Ditch, NarrowerThanTheSupportIsCrossed) {
  for (const double x : {-32.0, -36.0}) {
    Mission dut = RunMission(Across(x), "slope_ramps");
    Extremes seen;
    seen.Watch(dut.rig());
    PlayScript(dut, 300s);
    EXPECT_GT(seen.nose_down, -1 * kDegree) << x;
    EXPECT_NEAR(dut.rig().simulator().last().state.position.z(), 0, 0.02) << x;
  }
}

TEST(Ditch, WiderThanTheSupportSwallowsTheNose) {
  Mission dut = RunMission(Across(-40), "slope_ramps");
  Extremes seen;
  seen.Watch(dut.rig());
  ASSERT_TRUE(dut.Run(300s));
  EXPECT_LT(seen.nose_down, -3 * kDegree);
}

}  // namespace
}  // namespace eod::lockstep
