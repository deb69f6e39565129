#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/scenario/terrain_lanes.h"

namespace eod::lockstep {
namespace {

using namespace std::chrono_literals;

constexpr double kDegree = std::numbers::pi / 180;

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
