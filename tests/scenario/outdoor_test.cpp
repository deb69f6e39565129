// Driving in the outdoor module, through the box.
#include <gtest/gtest.h>

#include "tests/scenario/terrain_lanes.h"

namespace eod::lockstep {
namespace {

using namespace std::chrono_literals;

/// Front flippers raised, rear ones level: before a kerb.
constexpr std::string_view kApproach =
    "hold M06 until joint 1 <= 45.4 within 9s\nhold M08 until joint 2 <= 0.4 within 9s\n"
    "wait 500ms\n";

/// An exercise that goes on for as long as the script does.
Mission RunOutdoors(const std::string& text) {
  sim::Scenario scenario = ShippedScenario("slope_ramps");
  scenario.module = 4;
  sim::TaskStep far;
  far.kind = sim::TaskStep::Kind::kReach;
  far.tolerance = 1;
  far.x = far.y = -240;
  scenario.steps = {far};
  return Mission(box::ParseScript(PowerUp("outdoor") + text, "test.boxscript"), scenario);
}

std::string Drive(std::string_view motion, double metres) {
  return fmt::format("speed low\nhold {} until travel {} {} within 120s\nwait 1s\n", motion,
                     metres > 0 ? ">=" : "<=", metres);
}

TEST(Street, KerbIsDrivenUpAndBackDown) {
  Mission dut = RunOutdoors(TurnTo(270, false) + std::string(kApproach) + Drive("M01", 4.7) +
                            "expect lamp collision off\nnote \"up\"\n" + Drive("M02", -3) +
                            "expect lamp tilt off\n");
  double high = 0, tilt = 0;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    const sim::RobotState& state = step.state;
    if (state.position.x() < 4.6) return;
    high = std::max(high, state.position.z());
    tilt = std::max(tilt, std::abs(state.attitude.pitch));
  });
  PlayScript(dut, 120s);
  EXPECT_NEAR(high, 0.15, 1e-3);
  EXPECT_LT(tilt, 0.1 * kDegree);
  const sim::RobotState& end = dut.rig().simulator().last().state;
  EXPECT_LT(end.position.x(), 2.5);
  EXPECT_NEAR(end.position.z(), 0, 1e-3);
}

/// From the start to y = 87 before the station of the builders' yard at x, heading 0.
std::string ToStation(double x) {
  return DriveAhead(60) + DriveAhead(27) + TurnTo(270, false) + DriveAhead(x) +
         TurnTo(359.75, true) + std::string(kApproach);
}

struct Station {
  std::string name;
  double x;
  double metres;       ///< to drive north
  double lowest_rise;  ///< [m] that it comes to
  double tilt_deg;     ///< that it stays below
};
class YardStation : public ::testing::TestWithParam<Station> {};

TEST_P(YardStation, IsDrivenOverWithoutAnAlarm) {
  const Station& station = GetParam();
  Mission dut = RunOutdoors(ToStation(station.x) + Drive("M01", station.metres) +
                            "expect lamp collision off\nexpect lamp tilt off\n");
  double rise = 0, tilt = 0;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    const sim::RobotState& state = step.state;
    EXPECT_FALSE(state.rolls_over);
    rise = std::max(rise, state.position.z());
    tilt = std::max({tilt, std::abs(state.attitude.pitch), std::abs(state.attitude.roll)});
  });
  PlayScript(dut, 600s);
  const sim::RobotState& end = dut.rig().simulator().last().state;
  EXPECT_NEAR(end.position.x(), station.x, 0.6);
  EXPECT_GT(end.position.y(), 87 + 0.9 * station.metres);
  EXPECT_GT(rise, station.lowest_rise);
  EXPECT_LT(tilt, station.tilt_deg * kDegree);
}

INSTANTIATE_TEST_SUITE_P(
    Yard, YardStation,
    ::testing::Values(Station{"Gravel", 22, 14, 0.02, 5}, Station{"PitchAndRoll", 28, 18, 0.08, 20},
                      Station{"Stepfield", 34, 14, 0.20, 25}, Station{"Ditch", 40, 12, -0.01, 15},
                      Station{"LoadingDock", 46, 17, 0.99, 12}, Station{"Bank", 66, 13, 0.9, 21}),
    [](const auto& station) { return station.param.name; });

}  // namespace
}  // namespace eod::lockstep
