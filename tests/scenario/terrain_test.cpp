#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/scenario/operator_script.h"

namespace eod::lockstep {
namespace {

using namespace std::chrono_literals;

constexpr double kDegree = std::numbers::pi / 180;

/// To y = 6.5 before the station of the lane at x, heading 0.
std::string ToLane(double x) {
  std::string text = PowerUp("slope") + DriveAhead(4);
  if (x > 0) text += TurnTo(270, false) + DriveAhead(x) + TurnTo(359.75, true);
  if (x < 0) text += TurnTo(90, true) + DriveAhead(-x) + TurnTo(0.25, false);
  return text + DriveAhead(2.5);
}

/// What a mission came to, for one look at all of it.
struct Extremes {
  double pitch = 0, nose_down = 0, z = 0;  ///< [rad], [m]
  void Watch(LockStepRig& rig) {
    rig.SetStepSink([this](const sim::StepResult& step, const sim::AlarmTable&) {
      pitch = std::max(pitch, step.state.attitude.pitch);
      nose_down = std::min(nose_down, step.state.attitude.pitch);
      z = std::max(z, step.state.position.z());
    });
  }
};

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

struct Stair {
  double x, rise, run;
  int steps;
};
class StairDrive : public ::testing::TestWithParam<Stair> {};

TEST_P(StairDrive, UpWithFlippersAndDownBackwards) {
  const Stair stair = GetParam();
  const double slope = std::atan2(stair.rise, stair.run);
  const double top = stair.rise * stair.steps;
  // From y = 6.5 to the middle of the platform, along ground, nosings and platform.
  const double way = 1.5 + std::hypot(stair.run, stair.rise) * stair.steps + 0.7;
  Mission dut = RunMission(
      ToLane(stair.x) + "hold preset stair_up until joint 4 <= 35.1 within 30s\nwait 1s\n" +
          fmt::format("speed low\nhold M01 until travel >= {0} within 60s\nwait 2s\n"
                      "expect lamp collision off\nexpect lamp tilt off\nnote \"top\"\n"
                      "hold M02 until travel <= -{0} within 60s\nwait 1s\n",
                      way),
      "slope_stairs");
  Extremes seen;
  seen.Watch(dut.rig());
  PlayScript(dut, 300s);
  // Its middle is a little higher while it tips over the last nosing.
  EXPECT_GT(seen.z, top - 0.02);
  EXPECT_LT(seen.z, top + 0.2);
  EXPECT_GT(seen.pitch, slope - 0.5 * kDegree);
  EXPECT_NEAR(dut.rig().simulator().last().state.position.z(), 0, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Stairs, StairDrive,
                         ::testing::Values(Stair{-4, 0.150, 0.300, 10}, Stair{-8, 0.165, 0.280, 9}),
                         [](const auto& stair) {
                           return fmt::format("Of{:.0f}Millimetres", 1000 * stair.param.rise);
                         });

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
