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
  return text + DriveAhead(2.5);
}

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
  double steepest = 0, highest = 0;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    steepest = std::max(steepest, step.state.attitude.pitch);
    highest = std::max(highest, step.state.position.z());
  });
  ASSERT_TRUE(dut.Run(300s));
  EXPECT_EQ(dut.box().script_failure(), std::nullopt);
  EXPECT_GT(steepest, (angle_deg - 0.1) * kDegree);
  EXPECT_NEAR(highest, 3 * std::sin(angle_deg * kDegree), 0.15);
  EXPECT_NEAR(dut.rig().simulator().last().state.position.z(), 0, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Slopes, RampDrive,
                         ::testing::Values(Ramp{4, 10}, Ramp{12, 20}, Ramp{20, 30}, Ramp{24, 35}),
                         [](const auto& ramp) {
                           return fmt::format("Of{}Degrees", ramp.param.angle_deg);
                         });

}  // namespace
}  // namespace eod::lockstep
