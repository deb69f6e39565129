// Charges taken, carried and put away, through the box.
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/scenario/charge_script.h"

namespace eod::lockstep {
namespace {

using namespace std::chrono_literals;

constexpr double kDegree = std::numbers::pi / 180;

Mission ShippedMission(const std::string& script, const std::string& scenario) {
  return Mission(box::LoadScript(kData / "firmware_emu/scripts" / (script + ".boxscript")),
                 ShippedScenario(scenario));
}

void ExpectSuccess(Mission& mission) {
  const sim::StepResult& last = mission.rig().simulator().last();
  EXPECT_EQ(last.task.state, sim::MissionState::kSuccess);
  EXPECT_EQ(last.disposal.bomb, sim::BombState::kInCan);
  const sim::ScoreSheet sheet = mission.rig().simulator().scorer().Sheet();
  EXPECT_TRUE(sheet.passed);
  EXPECT_DOUBLE_EQ(sheet.parts[0].points, sheet.parts[0].of);
  for (const sim::ScoreItem& item : sheet.parts[1].items) {
    // These scripts do not change cameras to look where they drive; all else is safe.
    EXPECT_EQ(item.points == 0, item.name != "unseen_driving") << item.name;
  }
}

struct Disposing {
  std::string script, scenario;
};
class WholeMission : public ::testing::TestWithParam<Disposing> {};

TEST_P(WholeMission, EndsInTheVesselAndPasses) {
  Mission dut = ShippedMission(GetParam().script, GetParam().scenario);
  PlayScript(dut, 300s);
  ExpectSuccess(dut);
}

INSTANTIATE_TEST_SUITE_P(Charges, WholeMission,
                         ::testing::Values(Disposing{"bomb_ground", "bomb_ground_m"},
                                           Disposing{"bomb_ground_m", "bomb_ground_m"},
                                           Disposing{"bomb_bench", "bomb_bench_l"},
                                           Disposing{"bomb_chamber", "bomb_chamber_m"}),
                         [](const auto& mission) { return mission.param.script; });

TEST(Disposal, FromTheTableToTheCanIsTheSameBitsTwice) {
  Mission first = ShippedMission("bomb_table", "bomb_table_s");
  Mission second = ShippedMission("bomb_table", "bomb_table_s");
  PlayScript(first, 300s);
  PlayScript(second, 300s);
  ExpectSuccess(first);
  EXPECT_TRUE(first.can_log() == second.can_log());
  EXPECT_TRUE(first.states() == second.states());
}

TEST(Disposal, EachHandStopsOnItsOwnWhereTheChargeIs) {
  Mission dut = RunMission(HandAtTheTable() + Open(0.05) + DriveAhead(2.85) +
                               "wait 500ms\npress M18\nwait grasp contact_right within 3s\n"
                               "wait grasp grasped within 3s\nrelease all\nwait 500ms\n",
                           "bomb_table_s");
  PlayScript(dut, 120s);
  const sim::StepResult& last = dut.rig().simulator().last();
  const sim::ExplosiveSpec charge{.radius = 0.030, .half_height = 0.080};
  // Where the charge is in the robot's frame, seen across the heading.
  const Eigen::Vector3d to_charge = last.charge - last.state.position;
  const double heading = last.state.attitude.heading;
  const double right = to_charge.x() * std::cos(heading) + to_charge.y() * std::sin(heading);
  ASSERT_GT(right, 0.005);  // beside the middle, so that the hands have different ways
  const double pad = ShippedData().rules.grasp.pad;
  EXPECT_NEAR(last.state.right_opening, charge.radius + right, pad);
  EXPECT_NEAR(last.state.left_opening, charge.radius - right, pad);
}

TEST(Disposal, TheGripperTurnsWithItsLoad) {
  Mission dut = RunMission(TakeChargeM() +
                               "hold M15 until joint 6 >= 30 within 5s\nwait 500ms\n"
                               "expect grasp grasped\nexpect bomb carried\n",
                           "bomb_ground_m");
  std::optional<double> pitch_when_taken;
  const auto pitch = [](const sim::RobotState& state) {
    return state.joint[sim::kBigArm] + state.joint[sim::kSmallArm] + state.joint[sim::kWrist] -
           std::numbers::pi;
  };
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    if (step.disposal.held_body >= 0 && !pitch_when_taken) pitch_when_taken = pitch(step.state);
  });
  PlayScript(dut, 120s);
  ASSERT_TRUE(pitch_when_taken.has_value());
  const sim::StepResult& last = dut.rig().simulator().last();
  using Eigen::AngleAxisd, Eigen::Vector3d;
  // It stood upright when it was taken; J6 is positive counter-clockwise, about -Y.
  const Vector3d axis = AngleAxisd(pitch(last.state), Vector3d::UnitX()) *
                        (AngleAxisd(-last.state.joint[sim::kGripperRoll], Vector3d::UnitY()) *
                         (AngleAxisd(-*pitch_when_taken, Vector3d::UnitX()) * Vector3d::UnitZ()));
  EXPECT_GT(std::acos(axis.z()), 30 * kDegree);
  EXPECT_NEAR(last.disposal.bomb_tilt, std::acos(axis.z()), 0.5 * kDegree);
}

TEST(Disposal, LetGoLowerThanTheDropRuleItStandsAgain) {
  Mission dut = RunMission(GraspChargeM() +
                               "rate 10%\nhold M09 for 5s\nrate 100%\nhold M17 for 1s\nwait 2s\n"
                               "expect bomb placed\nexpect mission run\n",
                           "bomb_ground_m");
  double highest = 0;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    if (step.disposal.held_body >= 0) highest = std::max(highest, step.charge.z());
  });
  PlayScript(dut, 120s);
  const sim::StepResult& last = dut.rig().simulator().last();
  const double fall = highest - last.charge.z();
  EXPECT_GT(fall, 0.05);
  EXPECT_LT(fall, ShippedData().rules.charge.drop);
  EXPECT_NEAR(last.charge.z(), 0.12, 0.002);  // half of its 240 mm
  EXPECT_EQ(last.disposal.detonation, sim::DetonationCause::kNone);
}

}  // namespace
}  // namespace eod::lockstep
