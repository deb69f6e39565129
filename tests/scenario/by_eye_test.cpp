// Scripts that go by eye: they come out right wherever the robot and the charges stand.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/scenario/operator_script.h"

namespace eod::lockstep {
namespace {

using namespace std::chrono_literals;

constexpr double kDegree = std::numbers::pi / 180;

struct Offset {
  double side, ahead;  // [m] of the start pad
  double heading_deg;
};

/// Drives blindly off the start pad, to where a moved start would have stood.
std::string MovedStart(const Offset& offset) {
  const bool right = offset.side > 0;
  return PowerUp("bomb") + "speed low\n" +
         fmt::format("hold {} for 3s\nwait 300ms\n", right ? "M04" : "M03") +
         fmt::format("hold M01 until travel >= {} within 9s\nwait 500ms\n", std::abs(offset.side)) +
         fmt::format("hold {} for {:.3f}s\nwait 300ms\n", right ? "M03" : "M04",
                     (90 + (right ? 1 : -1) * offset.heading_deg) / 30) +
         fmt::format("hold {} for {:.3f}s\nwait 500ms\n", offset.ahead > 0 ? "M01" : "M02",
                     std::abs(offset.ahead) / 0.3);
}

class MovedBy : public ::testing::TestWithParam<Offset> {};

TEST_P(MovedBy, TheChargeIsGraspedAllTheSame) {
  Mission dut = RunMission(MovedStart(GetParam()) +
                               "hold preset ground_pick until joint 4 >= 108.6 within 20s\n"
                               "hold M17 until joint 7 >= 0.08 within 4s\n"
                               "approach charge_m at 1.20 within 90s\n"
                               "hold M18 until grasp grasped within 6s\nwait 500ms\n",
                           "bomb_ground_m");
  PlayScript(dut, 200s);
  const sim::StepResult& last = dut.rig().simulator().last();
  EXPECT_EQ(last.disposal.grasp, sim::GraspState::kGrasped);
  EXPECT_LE(last.task.collisions, 1);  // the pads on the charge
}

INSTANTIATE_TEST_SUITE_P(Starts, MovedBy,
                         ::testing::Values(Offset{0.3, 0.3, 10}, Offset{0.3, -0.3, -10},
                                           Offset{-0.3, 0.3, -10}, Offset{-0.3, -0.3, 10},
                                           Offset{0.3, 0.1, 0}));

/// Where the robot's origin and its heading [deg] are, in the module's frame.
struct Stand {
  double x, y, heading_deg;
};
Stand StandOf(Mission& mission) {
  const sim::RobotState& state = mission.rig().simulator().last().state;
  return {state.position.x(), state.position.y(), state.attitude.heading / kDegree};
}

TEST(ByEye, DrivesToPointsOneAfterTheOther) {
  struct Point {
    double x, y;
  };
  for (const std::string_view speed : {"low", "high"}) {
    for (const auto& [x, y] : {Point{3, 3}, Point{-3, 1}, Point{1, 0.5}, Point{-4, -2}}) {
      Mission dut = RunMission(
          PowerUp("flat") + fmt::format("speed {}\ndrive to {} {} within 60s\n", speed, x, y),
          "flat_first_drive");
      PlayScript(dut, 90s);
      const Stand at = StandOf(dut);
      EXPECT_NEAR(std::hypot(at.x - x, at.y - y), 0, 0.03) << speed << ' ' << x << ' ' << y;
    }
  }
}

TEST(ByEye, DrivesBackwards) {
  Mission dut =
      RunMission(PowerUp("flat") + "drive to 0.5 -3 backwards within 60s\n", "flat_first_drive");
  PlayScript(dut, 90s);
  const Stand at = StandOf(dut);
  EXPECT_NEAR(std::hypot(at.x - 0.5, at.y + 3), 0, 0.03);
  // Its rear looks from the start to the goal.
  const double heading = std::atan2(0.5, 3) / kDegree;
  EXPECT_NEAR(std::remainder(at.heading_deg - heading, 360), 0, 1.5);
}

class Turning : public ::testing::TestWithParam<double> {};
TEST_P(Turning, EndsAtTheHeading) {
  Mission dut = RunMission(PowerUp("flat") + fmt::format("turn to {} within 30s\n", GetParam()),
                           "flat_first_drive");
  PlayScript(dut, 60s);
  EXPECT_NEAR(std::remainder(StandOf(dut).heading_deg - GetParam(), 360), 0, 0.2);
}
INSTANTIATE_TEST_SUITE_P(Headings, Turning, ::testing::Values(90, 270, 180, 359, 2, -45));

Eigen::Vector3d CentreOf(Mission& mission, std::string_view movable) {
  const sim::Simulator& simulator = mission.rig().simulator();
  const auto& movables = simulator.module().movables;
  const auto found = std::find_if(movables.begin(), movables.end(),
                                  [movable](const auto& each) { return each.name == movable; });
  return simulator.bodies()[found - movables.begin()].X_MO * found->p_OC;
}

struct Place {
  double ahead, side;
};
class Approaching : public ::testing::TestWithParam<Place> {};
TEST_P(Approaching, EndsWithTheObjectThere) {
  const auto [ahead, side] = GetParam();
  Mission dut = RunMission(
      PowerUp("bomb") +
          fmt::format("speed high\napproach charge_m at {} {} within 90s\n", ahead, side),
      "bomb_ground_m");
  PlayScript(dut, 120s);
  const sim::StepResult& last = dut.rig().simulator().last();
  const Eigen::Vector3d to_charge = CentreOf(dut, "charge_m") - last.state.position;
  const double heading = last.state.attitude.heading;
  EXPECT_NEAR(-to_charge.x() * std::sin(heading) + to_charge.y() * std::cos(heading), ahead, 0.005);
  EXPECT_NEAR(to_charge.x() * std::cos(heading) + to_charge.y() * std::sin(heading), side, 0.005);
}
INSTANTIATE_TEST_SUITE_P(Places, Approaching,
                         ::testing::Values(Place{1.2, 0}, Place{1.5, 0.1}, Place{1.3, -0.2},
                                           Place{8, 0.5}));

TEST(ByEye, ALateLinkIsNoticedAndAllowedFor) {
  sim::Scenario scenario = ShippedScenario("bomb_ground_m");
  scenario.link.kind = sim::ControlLinkSpec::Kind::kRadio;
  scenario.link.commands.delay = scenario.link.telemetry.delay = 0.2;
  Mission dut(box::ParseScript(PowerUp("bomb") +
                                   "turn to 40 within 30s\nturn to 39 within 30s\n"
                                   "drive to 0 3 within 60s\napproach charge_m at 1.3 within 60s\n",
                               "test.boxscript"),
              scenario);
  PlayScript(dut, 200s);
  const Eigen::Vector3d to_charge =
      CentreOf(dut, "charge_m") - dut.rig().simulator().last().state.position;
  EXPECT_NEAR(to_charge.norm(), std::hypot(1.3, to_charge.z()), 0.005);
}

TEST(ByEye, GivesTheSpeedControlsBackAsTheyWere) {
  Mission dut = RunMission(
      PowerUp("bomb") + "speed high\nspeed_limit 90%\napproach charge_m at 1.5 within 90s\n",
      "bomb_ground_m");
  PlayScript(dut, 120s);
  const dbc::PanelState& controls = dut.box().hands().inputs().controls;
  EXPECT_EQ(controls.speed_range, dbc::SpeedRange::kHigh);
  EXPECT_EQ(controls.speed_limit, 0.9);
}

TEST(ByEye, TellsWhereThingsAre) {
  Mission dut = RunMission(PowerUp("bomb") +
                               "expect seen charge_m\nexpect distance charge_m > 5.9\n"
                               "expect ahead charge_m < 6.1\nexpect tilt charge_m < 0.5\n"
                               "expect x > -0.01\nexpect z < 0.01\nexpect ahead can > 17.9\n"
                               "expect side can < 0.1\nexpect height charge_m > 0.11\n",
                           "bomb_ground_m");
  PlayScript(dut, 30s);
}

TEST(ByEye, ARobotThatDoesNotObeyFailsTheLineWithWhatIsLeft) {
  Mission dut = RunMission(PowerUp("flat") + "deadman released\ndrive to 0 2 within 60s\n",
                           "flat_first_drive");
  ASSERT_TRUE(dut.Run(60s));
  ASSERT_TRUE(dut.box().script_failure());
  EXPECT_NE(dut.box().script_failure()->find(
                "drive to 0 2 within 60s: the robot does not move: 2.000 m and 0.0 deg are left"),
            std::string::npos)
      << *dut.box().script_failure();
}

TEST(ByEye, SameScriptSameBits) {
  const std::string script = PowerUp("bomb") + "turn to 30\napproach charge_m at 1.3 0.1\n";
  Mission first = RunMission(script, "bomb_ground_m"), second = RunMission(script, "bomb_ground_m");
  PlayScript(first, 120s);
  PlayScript(second, 120s);
  EXPECT_TRUE(first.can_log() == second.can_log());
  EXPECT_TRUE(first.states() == second.states());
}

}  // namespace
}  // namespace eod::lockstep
