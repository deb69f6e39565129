#include <cmath>

#include <gtest/gtest.h>

#include "tests/scenario/terrain_lanes.h"

namespace eod::lockstep {
namespace {

using namespace std::chrono_literals;

/// The operator's stance before an obstacle: front flippers raised, rear ones level.
constexpr std::string_view kApproach =
    "hold M06 until joint 1 <= 45.4 within 9s\nhold M08 until joint 2 <= 0.4 within 9s\n"
    "wait 500ms\n";

std::string Drive(double metres) {
  return fmt::format("speed low\nhold M01 until travel >= {} within 90s\nwait 1s\n", metres);
}

/// How often a value falls below `low` after it was above `high`.
struct Swings {
  double high, low;
  bool is_high = false;
  int count = 0;
  void Add(double value) {
    if (value < low && is_high) ++count;
    is_high = value > high || (is_high && value >= low);
  }
};

TEST(Kerb, IsDrivenUpAndDown) {
  Mission dut = RunMission(
      ToLane(0) + std::string(kApproach) + Drive(6) + "expect lamp collision off\n", "slope_ramps");
  double low = 1, high = 0, tilt = 0;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    const sim::RobotState& state = step.state;
    // Where the tracks, 0.525 m to either side, are wholly on it.
    if (state.position.y() < 8.55 || state.position.y() > 9.45) return;
    low = std::min(low, state.position.z());
    high = std::max(high, state.position.z());
    tilt = std::max(tilt, std::abs(state.attitude.pitch));
  });
  PlayScript(dut, 120s);
  EXPECT_NEAR(low, 0.15, 1e-3);
  EXPECT_NEAR(high, 0.15, 1e-3);
  EXPECT_LT(tilt, 0.1 * kDegree);
  const sim::RobotState& end = dut.rig().simulator().last().state;
  EXPECT_GT(end.position.y(), 12);
  EXPECT_NEAR(end.position.z(), 0, 1e-3);
}

struct Bar {
  double x, height;
};

/// How far a track sinks over a round bar between two points of its belt, 0.075 m apart.
double Sag(double height) {
  const double radius = height / 2;
  return radius - std::sqrt(radius * radius - 0.0375 * 0.0375);
}

class LowBar : public ::testing::TestWithParam<Bar> {};

TEST_P(LowBar, IsCrossedInOneGo) {
  const auto [x, height] = GetParam();
  Mission dut =
      RunMission(ToLane(x) + std::string(kApproach) + Drive(3.5) + "expect lamp collision off\n",
                 "slope_ramps");
  Extremes seen;
  seen.Watch(dut.rig());
  PlayScript(dut, 300s);
  EXPECT_GT(seen.z, height - Sag(height));
  const sim::RobotState& end = dut.rig().simulator().last().state;
  EXPECT_GT(end.position.y(), 9.9);
  EXPECT_NEAR(end.position.z(), 0, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Bars, LowBar, ::testing::Values(Bar{-16, 0.10}, Bar{-20, 0.20}),
                         [](const auto& bar) {
                           return fmt::format("Of{:.0f}Centimetres", 100 * bar.param.height);
                         });

/// Rears up against the bar at x until the tilt limit stops it.
std::string RearUp(double x) {
  return ToLane(x) + std::string(kApproach) +
         "speed creep\nhold M01 until reason tilt within 30s\n";
}

TEST(HighBar, AtTheLimitIsCrossedWithFlippersPressedDown) {
  Mission dut = RunMission(
      RearUp(-24) +
          "hold M08 until pitch <= 22 within 6s\nwait 300ms\nnote \"over\"\n"
          "hold M01 until travel >= 0.1 within 6s\nwait 300ms\n"
          "hold M06 until joint 1 <= -30 within 9s\nwait 300ms\n"
          "hold M01 until travel >= 0.5 within 9s\nhold M07 until joint 2 >= 0 within 9s\n"
          "hold M01 until travel >= 1.2 within 19s\n"
          "hold M05 until joint 1 >= 0 within 9s\nwait 1s\n"
          "expect lamp collision off\nexpect lamp tilt off\nexpect mission run\n",
      "slope_ramps");
  Extremes seen;
  seen.Watch(dut.rig());
  PlayScript(dut, 300s);
  EXPECT_GT(seen.z, 0.40 - Sag(0.40));
  const sim::RobotState& end = dut.rig().simulator().last().state;
  EXPECT_GT(end.position.y(), 8 + 0.525 + 0.4);
  EXPECT_NEAR(end.position.z(), 0, 1e-3);
}

TEST(HighBar, AtTheLimitThrowsTheCarelessOverItsNose) {
  // The front flippers stay up, so that there is nothing to land on beyond it.
  Mission dut = RunMission(RearUp(-24) +
                               "hold M08 for 3s\nhold M01 until mission fail within 20s\n"
                               "wait failure rollover within 1s\nexpect lamp tilt on\n",
                           "slope_ramps");
  Extremes seen;
  seen.Watch(dut.rig());
  PlayScript(dut, 300s);
  EXPECT_LT(seen.nose_down, -45 * kDegree);
}

TEST(HighBar, AboveTheLimitIsNotCrossedAndLeavesTheWayBack) {
  // Back on the rear flippers, which go up when the tracks are off the bar.
  Mission dut = RunMission(RearUp(-28) +
                               "hold M08 until reason joint_limit within 6s\nwait 300ms\n"
                               "press M01\nwait reason tilt within 9s\nwait 9s\n"
                               "expect reason tilt\nrelease all\nwait 1s\n"
                               "hold M02 until travel <= -0.8 within 12s\n"
                               "hold M07 until joint 2 >= 0 within 9s\n"
                               "hold M02 until travel <= -0.5 within 12s\nwait 1s\n"
                               "expect lamp tilt off\nexpect lamp collision off\n"
                               "expect mission run\n",
                           "slope_ramps");
  double farthest = 0;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    farthest = std::max(farthest, step.state.position.y());
  });
  PlayScript(dut, 300s);
  EXPECT_LT(farthest, 8);
  EXPECT_NEAR(dut.rig().simulator().last().state.position.z(), 0, 1e-3);
}

TEST(CrossingRamps, RollAndPitchAlternate) {
  const double peak = std::atan2(0.17, 0.59);
  Mission dut = RunMission(
      ToLane(44) + Drive(7.5) + "expect lamp collision off\nexpect lamp tilt off\n", "slope_ramps");
  Swings roll{5 * kDegree, -5 * kDegree};
  Swings pitch{0.75 * peak, 0.25 * peak};
  double most = 0;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    const sim::Attitude& attitude = step.state.attitude;
    roll.Add(attitude.roll);
    pitch.Add(attitude.pitch);
    most = std::max(most, std::abs(attitude.roll));
  });
  PlayScript(dut, 400s);
  // Three peaks on either side in turn, the left one first.
  EXPECT_EQ(roll.count, 3);
  // Over each peak the nose drops, but over the first, which is on the left alone.
  EXPECT_EQ(pitch.count, 5);
  // One track on a peak and the other on the ground, 0.6 m beside it.
  EXPECT_LT(most, std::atan2(0.17, 0.6) + 0.5 * kDegree);
  EXPECT_GT(most, 0.75 * std::atan2(0.17, 0.6));
  const sim::RobotState& end = dut.rig().simulator().last().state;
  EXPECT_GT(end.position.y(), 8 + 7 * 0.59 + 0.525);
  EXPECT_NEAR(end.position.z(), 0, 1e-3);
}

TEST(Stepfield, IsCrossed) {
  Mission dut = RunMission(ToLane(-44) +
                               "hold M06 until joint 1 <= 30.4 within 9s\n"
                               "hold M08 until joint 2 <= 0.4 within 9s\nwait 500ms\n" +
                               Drive(6) + "expect lamp collision off\nexpect lamp tilt off\n",
                           "slope_ramps");
  Extremes seen;
  seen.Watch(dut.rig());
  PlayScript(dut, 400s);
  EXPECT_GT(seen.z, 0.10);
  EXPECT_GT(seen.pitch, 5 * kDegree);
  EXPECT_LT(seen.nose_down, -5 * kDegree);
  const sim::RobotState& end = dut.rig().simulator().last().state;
  EXPECT_GT(end.position.y(), 8 + 3 + 0.525);
  EXPECT_NEAR(end.position.z(), 0, 1e-3);
}

}  // namespace
}  // namespace eod::lockstep
