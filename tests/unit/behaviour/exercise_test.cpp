// Exercises that begin elsewhere, place things, and are chosen while the simulator runs.
#include <fstream>
#include <map>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/scenario/catalogue.h"
#include "sim/scenario/variation.h"
#include "tests/unit/behaviour/operator.h"

namespace eod::sim {
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;

Scenario In(int module, const std::string& name) {
  Scenario scenario;
  scenario.file = name + ".toml";
  scenario.name = name;
  scenario.module = module;
  TaskStep step;
  step.kind = TaskStep::Kind::kReach;
  step.x = 40;
  step.tolerance = 0.5;
  scenario.steps = {step};
  return scenario;
}

Placement PlaceOf(const std::string& object, const Eigen::Vector3d& p_M) {
  Placement place;
  place.object = object;
  place.position = p_M;
  place.line = 7;
  return place;
}

/// Somebody at the controls of an exercise, and an instructor.
struct Lesson {
  Simulator dut;
  OperatorCommand command;
  TimePoint now{};

  explicit Lesson(const Scenario& scenario, std::vector<Scenario> catalogue = {},
                  SimulatorConfig config = {})
      : dut(TheSharpRobot(), TheWorld(), scenario, With(config, std::move(catalogue))) {
    command.motion_permitted = true;
  }
  static SimulatorConfig With(SimulatorConfig config, std::vector<Scenario> catalogue) {
    config.catalogue = std::move(catalogue);
    return WithRules(config);
  }
  const StepResult& Step(int times = 1) {
    for (int i = 0; i < times; ++i) {
      now += milliseconds(4);
      command.stamp = command.heard = now;
      dut.Step(now, command);
    }
    return dut.last();
  }
  const StepResult& Menu(int module, int exercise, int menu_command = kMenuStart) {
    command.menu_module = module;
    command.menu_exercise = exercise;
    command.menu_command = menu_command;
    Step();
    command.menu_command = kMenuNone;
    return Step();
  }
  std::string name() const { return dut.scenario().name; }
  const RobotState& state() const { return dut.last().state; }
  Eigen::Vector3d Where(const std::string& movable) const {
    const auto& movables = dut.module().movables;
    for (size_t i = 0; i < movables.size(); ++i) {
      if (movables[i].name == movable) return dut.bodies()[i].X_MO.translation();
    }
    ADD_FAILURE() << movable;
    return {};
  }
};

TEST(Exercise, BeginsWhereItSaysAndAgainAfterAReset) {
  Scenario scenario = In(1, "a");
  scenario.start.position = Eigen::Vector3d(-3, -6, 0);
  scenario.start.heading = 90 * kDegree;
  Lesson dut(scenario);
  EXPECT_LT((dut.Step().state.position - *scenario.start.position).norm(), 1e-9);
  EXPECT_NEAR(dut.state().attitude.heading, 90 * kDegree, 1e-12);
  dut.command.motion_rate[kDriveForward] = 1;
  dut.Step(250);
  EXPECT_LT(dut.state().position.x(), -3.1);
  dut.command.motion_rate = {};
  dut.Menu(0, 0, kMenuReset);
  EXPECT_LT((dut.state().position - *scenario.start.position).norm(), 1e-9);
}

TEST(Exercise, RepetitionMovesTheStartByWhatItDrew) {
  Scenario scenario = In(1, "a");
  scenario.start.spread = Eigen::Vector3d(0.15, 0.15, 3 * kDegree);
  const Scenario varied = Vary(scenario, 2);
  Lesson dut(varied);
  dut.Step();
  EXPECT_LT((dut.state().position.head<2>() - varied.start.shift.head<2>()).norm(), 1e-9);
  EXPECT_NEAR(
      std::remainder(dut.state().attitude.heading - varied.start.shift.z(), 2 * std::numbers::pi),
      0, 1e-9);
  EXPECT_GT(varied.start.shift.head<2>().norm(), 0);
}

TEST(Exercise, RobotIsPutOnTheGroundNearestBelow) {
  // The platform behind the ramp of 10 degrees is 3 m sin(10 deg) high.
  Scenario scenario = In(2, "a");
  scenario.start.position = Eigen::Vector3d(4, 11.95, 0.4);
  Lesson dut(scenario);
  dut.Step();
  EXPECT_NEAR(dut.state().position.z(), 3 * std::sin(10 * kDegree), 0.005);
  EXPECT_NEAR(dut.state().attitude.pitch, 0, 0.01);
}

TEST(Exercise, PlacedChargeStandsThereAndStaysThere) {
  Scenario scenario = In(3, "a");
  scenario.places = {PlaceOf("charge_m", {2, 9, 0.12})};
  Lesson dut(scenario);
  dut.Step(1000);
  EXPECT_LT((dut.Where("charge_m") - Eigen::Vector3d(2, 9, 0.12)).norm(), 1e-3);
  EXPECT_EQ(dut.dut.last().disposal.detonation, DetonationCause::kNone);
  dut.Menu(0, 0, kMenuReset);
  EXPECT_LT((dut.Where("charge_m") - Eigen::Vector3d(2, 9, 0.12)).norm(), 1e-3);
}

TEST(Exercise, ThingsThatAreNotPlacedStandWhereTheWorldHasThem) {
  Scenario moved = In(3, "moved");
  moved.places = {PlaceOf("charge_m", {2, 9, 0.12})};
  Lesson dut(moved, {In(3, "plain")});
  dut.Step();
  dut.Menu(3, 1);
  EXPECT_EQ(dut.name(), "plain");
  EXPECT_EQ(dut.Where("charge_m"), Eigen::Vector3d(0, 6, 0.12));
}

TEST(Exercise, WhatDoesNotFitIsRefusedWithFileAndLine) {
  const auto error_of = [](const Scenario& scenario) -> std::string {
    try {
      Lesson refused(scenario);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "accepted";
  };
  Scenario scenario = In(3, "a");
  scenario.places = {PlaceOf("chargem", {2, 9, 0.12})};
  EXPECT_EQ(error_of(scenario),
            "a.toml:7: object 'chargem' is no movable of module 3 (bomb); did you mean "
            "'charge_m'?");
  scenario.places = {PlaceOf("charge_m", {2, 9, 0.12}), PlaceOf("charge_m", {3, 9, 0.12})};
  EXPECT_EQ(error_of(scenario), "a.toml:7: object 'charge_m' is placed twice");
  scenario.places = {PlaceOf("charge_m", {61, 9, 0.12})};
  EXPECT_THAT(error_of(scenario), HasSubstr("beyond module 3 (bomb), allowed x within 60"));
  Scenario step = In(3, "a");
  step.steps[0].object = "bucket";
  step.steps[0].line = 12;
  EXPECT_EQ(error_of(step), "a.toml:12: object 'bucket' is not in module 3 (bomb)");
}

TEST(Exercise, StartOutsideOfItsAreaIsRefused) {
  Scenario scenario = In(1, "a");
  scenario.area = {{1, -1}, {3, -1}, {3, 1}, {1, 1}};
  scenario.start.position = Eigen::Vector3d(2, 0, 0);
  EXPECT_NO_THROW(CheckFits(scenario, TheWorld()));
  scenario.start.position = Eigen::Vector3d(4, 0, 0);
  EXPECT_THROW(CheckFits(scenario, TheWorld()), std::runtime_error);
}

const std::vector<Scenario>& Shipped() {
  static const std::vector<Scenario> catalogue = LoadCatalogue(kData / "sim/scenarios");
  return catalogue;
}

TEST(ShippedScenarios, FitTheWorldAndEveryModuleThatIsThereHasSome) {
  std::map<int, int> count;
  for (const Scenario& scenario : Shipped()) {
    EXPECT_NO_THROW(CheckFits(scenario, TheWorld())) << scenario.name;
    EXPECT_EQ(scenario.name, scenario.file.stem().string());
    EXPECT_FALSE(scenario.steps.empty()) << scenario.name;
    EXPECT_GT(scenario.par_time_s, 0) << scenario.name;
    EXPECT_FALSE(scenario.title.empty()) << scenario.name;
    ++count[scenario.module];
  }
  for (const ModuleModel& module : TheWorld().modules) {
    EXPECT_GE(count[module.id], 2) << module.name;
    EXPECT_LE(count[module.id], 15) << module.name << ": the menu has four bits";
  }
}

TEST(ScenarioFormat, TheExampleOfItsReferenceIsAnExercise) {
  std::ifstream in(kData / "docs/scenario_format.md");
  std::stringstream page;
  page << in.rdbuf();
  const std::string text = page.str();
  const std::string fence = "```toml\n";
  const size_t begin = text.find(fence) + fence.size();
  ASSERT_GE(begin, fence.size());
  const auto file = std::filesystem::path(::testing::TempDir()) / "example_of_the_reference.toml";
  std::ofstream(file) << text.substr(begin, text.find("```", begin) - begin);
  const Scenario example = LoadScenario(file);
  EXPECT_NO_THROW(CheckFits(example, TheWorld()));
  EXPECT_EQ(example.steps.size(), 2u);
  EXPECT_EQ(example.faults.size(), 1u);
}

TEST(ShippedScenarios, EveryVariationBeginsCalmly) {
  for (const Scenario& scenario : Shipped()) {
    for (uint64_t repetition = 0; repetition <= 10; ++repetition) {
      Lesson dut(Vary(scenario, repetition), {}, {.start_mission = true});
      dut.Step();
      const RobotState first = dut.state();
      dut.Step(750);  // 3 s, in which whatever was moved has settled
      const StepResult& last = dut.dut.last();
      SCOPED_TRACE(scenario.name + " " + std::to_string(repetition));
      EXPECT_EQ(last.task.state, MissionState::kRun);
      EXPECT_EQ(last.task.collisions, 0);
      EXPECT_TRUE(dut.dut.scorer().events().empty());
      EXPECT_TRUE(last.state == first);
      for (const BodyState& body : dut.dut.bodies()) {
        EXPECT_FALSE(body.is_moving);
        EXPECT_GT(body.X_MO.linear()(2, 2), std::cos(0.1 * kDegree));
      }
    }
  }
}

TEST(ExerciseMenu, NumberChoosesAmongTheModulesExercises) {
  Lesson dut(In(1, "loaded"), {In(1, "flat_1"), In(1, "flat_2"), In(3, "bomb_1"), In(3, "bomb_2")});
  dut.Step();
  EXPECT_EQ(dut.name(), "loaded");
  EXPECT_EQ(dut.Menu(1, 2).task.state, MissionState::kRun);
  EXPECT_EQ(dut.name(), "flat_2");
  dut.Menu(3, 2);
  EXPECT_EQ(dut.name(), "bomb_2");
  EXPECT_EQ(dut.dut.last().module, 3);
  dut.Menu(0, 1);  // of the module that it is in
  EXPECT_EQ(dut.name(), "bomb_1");
}

TEST(ExerciseMenu, ZeroIsTheLoadedOneOrTheModulesFirst) {
  Lesson dut(In(1, "loaded"), {In(1, "flat_1"), In(3, "bomb_1"), In(3, "bomb_2")});
  dut.Menu(3, 0);
  EXPECT_EQ(dut.name(), "bomb_1");
  dut.Menu(1, 0);
  EXPECT_EQ(dut.name(), "loaded");
  EXPECT_EQ(dut.Menu(2, 0).task.state, MissionState::kIdle);  // free driving
  EXPECT_EQ(dut.name(), "");
  EXPECT_EQ(dut.dut.last().module, 2);
  dut.Menu(3, 9);  // there is none
  EXPECT_EQ(dut.name(), "bomb_1");
}

TEST(Instructor, LoadsByNameWithItsRepetitionAndStartsIt) {
  Scenario other = In(3, "other");
  other.start.spread = Eigen::Vector3d(0.15, 0.15, 0);
  Lesson dut(In(1, "loaded"), {other});
  dut.Step();
  EXPECT_TRUE(dut.dut.Instruct({.scenario = "other", .repetition = 4}));
  EXPECT_EQ(dut.Step().task.state, MissionState::kIdle);
  EXPECT_EQ(dut.name(), "other");
  EXPECT_EQ(dut.dut.scenario().repetition, 4u);
  const Eigen::Vector2d drawn = Vary(other, 4).start.shift.head<2>();
  EXPECT_LT((dut.state().position.head<2>() - drawn).norm(), 1e-9);
  dut.dut.Instruct({.scenario = "", .menu_command = kMenuStart});
  EXPECT_EQ(dut.Step().task.state, MissionState::kRun);
  // The trainee's menu comes back to it.
  dut.Menu(1, 0);
  dut.Menu(3, 0);
  EXPECT_EQ(dut.dut.scenario().repetition, 4u);
}

TEST(Instructor, UnknownNameChangesNothing) {
  Lesson dut(In(1, "loaded"), {In(1, "flat_1")});
  dut.Step();
  EXPECT_FALSE(dut.dut.Instruct({.scenario = "flat_7", .menu_command = kMenuStart}));
  EXPECT_EQ(dut.Step().task.state, MissionState::kIdle);
  EXPECT_EQ(dut.name(), "loaded");
}

TEST(Instructor, EmergencyStopHoldsTheRobotAndFailsTheMission) {
  Lesson dut(In(1, "a"), {}, {.start_mission = true});
  dut.command.motion_rate[kDriveForward] = 1;
  dut.Step(100);
  dut.dut.Instruct({.scenario = "", .estop = true});
  dut.Step();
  EXPECT_EQ(dut.dut.last().task.fail_reason, FailReason::kEstop);
  EXPECT_EQ(dut.dut.last().inhibit_reason, kReasonEstop);
  EXPECT_EQ(dut.dut.last().inhibited, SetOf(kDriveForward));
  const RobotState stopped = dut.state();
  EXPECT_EQ(dut.Step(50).state, stopped);
  dut.dut.Instruct({});
  dut.Step(50);
  EXPECT_NE(dut.state(), stopped);
}

TEST(Instructor, PausesResumesAndEnds) {
  Lesson dut(In(1, "a"), {}, {.start_mission = true});
  dut.command.motion_rate[kDriveForward] = 1;
  dut.Step(10);
  dut.dut.Instruct({.scenario = "", .menu_command = kMenuPause});
  dut.Step();
  const RobotState paused = dut.state();
  EXPECT_EQ(dut.Step(20).state, paused);
  dut.dut.Instruct({.scenario = "", .menu_command = kMenuResume});
  dut.Step(20);
  EXPECT_NE(dut.state(), paused);
  dut.dut.Instruct({.scenario = "", .menu_command = kMenuEnd});
  EXPECT_EQ(dut.Step().task.state, MissionState::kFail);
  EXPECT_EQ(dut.dut.last().task.fail_reason, FailReason::kInstructor);
}

TEST(Link, SilenceOfTheOperatorsCommandsIsALostLink) {
  Lesson dut(In(1, "a"), {}, {.start_mission = true});
  dut.Step(10);
  const double limit = WithRules().exercise.critical.link_lost;
  const auto steps = static_cast<int>(limit / 0.004);
  for (int i = 0; i < steps - 1; ++i) {
    dut.now += milliseconds(4);
    dut.dut.Step(dut.now, dut.command);
  }
  EXPECT_EQ(dut.dut.last().task.state, MissionState::kRun);
  dut.now += milliseconds(4);
  dut.dut.Step(dut.now, dut.command);
  EXPECT_EQ(dut.dut.last().task.fail_reason, FailReason::kLinkLost);
}

}  // namespace
}  // namespace eod::sim
