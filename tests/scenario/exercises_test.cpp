// The shipped exercises, each driven through by its script; and choosing among them by the box.
#include <gtest/gtest.h>

#include "sim/scenario/catalogue.h"
#include "tests/scenario/charge_script.h"

namespace eod::lockstep {
namespace {

using namespace std::chrono_literals;

const sim::TaskStatus& TaskOf(Mission& mission) { return mission.rig().simulator().last().task; }

class ShippedExercise : public ::testing::TestWithParam<const char*> {};

TEST_P(ShippedExercise, IsPassedByItsScriptWithinItsPar) {
  const sim::Scenario scenario = ShippedScenario(GetParam());
  Mission dut(box::LoadScript(kData / "firmware_emu/scripts" / (scenario.name + ".boxscript")),
              scenario);
  PlayScript(dut, 600s);
  EXPECT_EQ(TaskOf(dut).state, sim::MissionState::kSuccess);
  EXPECT_GE(TaskOf(dut).score, scenario.rubric.pass);
  EXPECT_LT(TaskOf(dut).elapsed_s, scenario.par_time_s);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedExercise,
                         ::testing::Values("flat_gates", "flat_slalom", "flat_figure_eight",
                                           "flat_plates_night", "slope_first", "slope_hold_rain",
                                           "slope_stairs_night", "bomb_ground_m_night",
                                           "bomb_table_s_blind", "bomb_two_devices"),
                         [](const auto& exercise) { return std::string(exercise.param); });

TEST(ExerciseByBox, MenuChoosesModuleAndExercise) {
  RigConfig config = Mission::ShippedRig();
  config.sim.simulator.catalogue = sim::LoadCatalogue(kData / "sim/scenarios");
  Mission dut(box::ParseScript(PowerUp("flat") + "expect mission run\nmenu module bomb\n"
                                                 "menu exercise 2\nmenu start\n"
                                                 "wait module bomb within 5s\nwait 500ms\n",
                               "test.boxscript"),
              ShippedScenario("flat_first_drive"), config);
  PlayScript(dut, 60s);
  EXPECT_EQ(dut.rig().simulator().scenario().name, "bomb_ground_m");
  EXPECT_EQ(TaskOf(dut).state, sim::MissionState::kRun);
}

Mission DriveWith(const sim::Scenario& scenario, const std::string& script) {
  return Mission(box::ParseScript(script, "test.boxscript"), scenario);
}

TEST(Failure, LeavingTheAreaIsTold) {
  sim::Scenario scenario = ShippedScenario("flat_first_drive");
  scenario.area = {{-1.5, -1.5}, {1.5, -1.5}, {1.5, 1.5}, {-1.5, 1.5}};
  Mission dut = DriveWith(scenario, PowerUp("flat") +
                                        "speed high\nhold M01 until mission fail within 10s\n"
                                        "wait failure out_of_area within 1s\n");
  PlayScript(dut, 60s);
  EXPECT_GT(dut.rig().simulator().last().state.position.y(), 1.5);
}

TEST(Failure, ACarriedChargeThatLeavesTheAreaIsLost) {
  sim::Scenario scenario = ShippedScenario("bomb_ground_m");
  scenario.area = {{-3, -3}, {3, -3}, {3, 7}, {-3, 7}};
  Mission dut = DriveWith(scenario, TakeChargeM() +
                                        "speed low\nhold M01 until mission fail within 30s\n"
                                        "wait failure bomb_lost within 1s\n");
  PlayScript(dut, 120s);
  const sim::StepResult& last = dut.rig().simulator().last();
  EXPECT_GT(last.charge.y(), 7);
  EXPECT_LT(last.state.position.y(), 7);
}

TEST(Failure, TheSecondDeviceBeforeTheFirstIsTheWrongOrder) {
  Mission dut = RunMission(
      GraspChargeM() + "wait mission fail within 1s\nwait failure wrong_order within 1s\n",
      "bomb_two_devices");
  PlayScript(dut, 120s);
}

TEST(Failure, AnOperatorWhoDoesNotGetHisLinkBackHasLostIt) {
  Mission dut = RunMission(PowerUp("flat") + "wait 1s\n", "flat_first_drive");
  PlayScript(dut, 60s);
  dut.rig().UnplugBox();
  const auto limit = std::chrono::duration_cast<Duration>(
      std::chrono::duration<double>(ShippedData().rules.critical.link_lost));
  // The bridge notices after 100 ms.
  dut.rig().RunFor(limit);
  EXPECT_EQ(TaskOf(dut).state, sim::MissionState::kRun);
  dut.rig().RunFor(200ms);
  EXPECT_EQ(TaskOf(dut).fail_reason, sim::FailReason::kLinkLost);
}

TEST(Failure, TimeRunsOut) {
  sim::Scenario scenario = ShippedScenario("flat_first_drive");
  scenario.time_limit_s = 5;
  Mission dut = DriveWith(scenario, PowerUp("flat") +
                                        "wait mission fail within 10s\n"
                                        "wait failure time_out within 1s\n");
  PlayScript(dut, 60s);
  EXPECT_DOUBLE_EQ(TaskOf(dut).elapsed_s, 5);
}

}  // namespace
}  // namespace eod::lockstep
