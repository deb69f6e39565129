#include "sim/task/task.h"

#include <fstream>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/behaviour/fixture.h"

namespace eod::sim {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

ModuleModel Flat() {
  ModuleModel module;
  module.id = 1;
  module.name = "flat";
  for (const char* name : {"wall", "gate_1", "board"}) {
    WorldObject object;
    object.name = name;
    module.objects.push_back(object);
  }
  // Driven through along X: its opening is along Y.
  module.objects[1].X_MO.translation() = Eigen::Vector3d(-4, 1.9, 0);
  return module;
}

/// A mission under way, fed by hand.
struct Mission {
  RobotState state;
  TaskInputs inputs;
  Task task;

  explicit Mission(std::vector<TaskStep> steps, double time_limit_s = 0)
      : task(Make(std::move(steps), time_limit_s), Flat()) {
    inputs.dt_s = 0.1;
    inputs.state = &state;
    inputs.forward_clearance = std::numeric_limits<double>::infinity();
    inputs.started = true;
    Step();
    inputs.started = false;
  }
  static Scenario Make(std::vector<TaskStep> steps, double time_limit_s) {
    Scenario scenario;
    scenario.steps = std::move(steps);
    scenario.time_limit_s = time_limit_s;
    return scenario;
  }
  TaskStatus Step() { return task.Advance(inputs); }
};

TaskStep StepOf(TaskStep::Kind kind, const std::string& object, double distance = 0,
                double tolerance = 0) {
  TaskStep step;
  step.kind = kind;
  step.object = object;
  step.distance = distance;
  step.tolerance = tolerance;
  return step;
}

TEST(Task, WaitsIdleUntilItIsStarted) {
  Task dut(Mission::Make({StepOf(TaskStep::Kind::kContact, "wall")}, 0), Flat());
  RobotState state;
  TaskInputs inputs;
  inputs.state = &state;
  inputs.in_contact = true;
  inputs.contact_object = "wall";
  EXPECT_EQ(dut.Advance(inputs).state, MissionState::kIdle);
  EXPECT_EQ(dut.step_text(), "");
}

TEST(Task, ContactWithTheWrongObjectDoesNotCountAndCostsTwoPoints) {
  Mission dut({StepOf(TaskStep::Kind::kContact, "wall"), StepOf(TaskStep::Kind::kContact, "wall")});
  dut.inputs.in_contact = dut.inputs.new_contact = true;
  dut.inputs.contact_object = "board";
  EXPECT_EQ(dut.Step().step, 0);
  dut.inputs.contact_object = "wall";
  const TaskStatus status = dut.Step();
  EXPECT_EQ(status.step, 1);
  EXPECT_EQ(status.collisions, 2);
  EXPECT_DOUBLE_EQ(status.score, 50 - 2);
}

TEST(Task, ClearMeasuresFromWhereTheContactWas) {
  Mission dut({StepOf(TaskStep::Kind::kContact, ""), StepOf(TaskStep::Kind::kClear, "", 0.5)});
  dut.state.position.y() = 3;
  dut.inputs.in_contact = true;
  dut.Step();
  dut.inputs.in_contact = false;
  dut.state.position.y() = 2.51;
  EXPECT_EQ(dut.Step().step, 1);
  dut.state.position.y() = 2.49;
  EXPECT_EQ(dut.Step().state, MissionState::kSuccess);
}

TEST(Task, GateCountsBetweenItsPostsOnly) {
  const auto pass_at = [](double y) {
    Mission dut({StepOf(TaskStep::Kind::kPassGate, "gate_1", 1.2)});
    dut.state.position = {-3.9, y, 0};
    dut.Step();
    dut.state.position.x() = -4.1;
    return dut.Step().state == MissionState::kSuccess;
  };
  EXPECT_TRUE(pass_at(1.9));
  EXPECT_TRUE(pass_at(1.9 + 0.59));
  EXPECT_FALSE(pass_at(1.9 + 0.61));
  EXPECT_FALSE(pass_at(1.9 - 0.61));
}

TEST(Task, StopWantsAWholeSecondOnTheMark) {
  Mission dut({StepOf(TaskStep::Kind::kStopAt, "board", 0.30, 0.05)});
  dut.inputs.forward_object = "board";
  dut.inputs.forward_clearance = 0.34;
  for (int i = 0; i < 9; ++i) EXPECT_EQ(dut.Step().state, MissionState::kRun);
  dut.inputs.speed = 0.1;  // moved: counts anew
  dut.Step();
  dut.inputs.speed = 0;
  for (int i = 0; i < 9; ++i) EXPECT_EQ(dut.Step().state, MissionState::kRun);
  EXPECT_EQ(dut.Step().state, MissionState::kSuccess);
}

TEST(Task, StopBesideTheMarkOrBeforeAnotherThingDoesNotCount) {
  for (const auto& [object, clearance] :
       {std::pair("board", 0.36), std::pair("board", 0.24), std::pair("wall", 0.30)}) {
    Mission dut({StepOf(TaskStep::Kind::kStopAt, "board", 0.30, 0.05)});
    dut.inputs.forward_object = object;
    dut.inputs.forward_clearance = clearance;
    for (int i = 0; i < 30; ++i) dut.Step();
    EXPECT_EQ(dut.task.status().state, MissionState::kRun) << object << " " << clearance;
  }
}

TEST(Task, ScoreNeverFallsBelowZero) {
  TaskStep far_away = StepOf(TaskStep::Kind::kReach, "");
  far_away.x = 9;
  Mission dut({far_away});
  dut.inputs.new_contact = true;
  EXPECT_EQ(dut.Step().score, 0);
}

TEST(Task, TimeLimitFailsTheMission) {
  Mission dut({StepOf(TaskStep::Kind::kContact, "wall")}, 1.0);
  for (int i = 0; i < 9; ++i) EXPECT_EQ(dut.Step().state, MissionState::kRun);
  const TaskStatus status = dut.Step();
  EXPECT_EQ(status.state, MissionState::kFail);
  EXPECT_EQ(status.fail_reason, FailReason::kTimeOut);
  EXPECT_DOUBLE_EQ(status.elapsed_s, 1.0);
}

TEST(Task, RolloverFailsAndTheMenuAborts) {
  Mission rolled({StepOf(TaskStep::Kind::kContact, "wall")});
  rolled.inputs.rolled_over = true;
  EXPECT_EQ(rolled.Step().fail_reason, FailReason::kRollover);
  Mission ended({StepOf(TaskStep::Kind::kContact, "wall")});
  ended.inputs.ended = true;
  EXPECT_EQ(ended.Step().state, MissionState::kAbort);
}

TEST(Task, UnknownObjectIsRefused) {
  Scenario scenario = Mission::Make({StepOf(TaskStep::Kind::kContact, "wal")}, 0);
  scenario.file = "x.toml";
  try {
    Task dut(scenario, Flat());
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "x.toml: object 'wal' is not in module 1 (flat)");
  }
}

// ---- the file

std::string LoadError(const std::string& text) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "scenario_under_test.toml";
  std::ofstream(file) << text;
  try {
    LoadScenario(file);
  } catch (const std::runtime_error& error) {
    std::string what = error.what();
    EXPECT_THAT(what, StartsWith(file.string() + ":"));
    EXPECT_EQ(what.find('\n'), std::string::npos);
    return what.substr(file.string().size() + 1);
  }
  return "no error";
}

TEST(LoadScenario, ReadsTheShippedOne) {
  const Scenario dut = LoadScenario(kData / "sim/scenarios/flat_first_drive.toml");
  EXPECT_EQ(dut.name, "flat_first_drive");
  EXPECT_EQ(dut.module, 1);
  ASSERT_EQ(dut.steps.size(), 4u);
  EXPECT_EQ(dut.steps[0].kind, TaskStep::Kind::kContact);
  EXPECT_EQ(dut.steps[1].distance, 0.5);
  EXPECT_EQ(dut.steps[2].object, "gate_1");
  EXPECT_EQ(dut.steps[3].tolerance, 0.05);
}

TEST(LoadScenario, ErrorsNameLineAndRemedy) {
  EXPECT_EQ(LoadError("name = 'a'\nmodule = 1\npar_tme_s = 3\n"),
            "3: unknown key 'par_tme_s'; did you mean 'par_time_s'?");
  EXPECT_EQ(LoadError("name = 'a'\nmodule = 7\n"), "2: module = 7, allowed 1 .. 5");
  EXPECT_EQ(LoadError("name = 'a'\nmodule = 'flat'\n"), "2: 'module' has to be a whole number");
  EXPECT_EQ(LoadError("name = 'a'\n"), "1: key 'module' is missing");
  EXPECT_THAT(LoadError("name = \n"), StartsWith("1: "));
  const std::string head = "name = 'a'\nmodule = 1\n[[step]]\n";
  EXPECT_EQ(LoadError(head + "kind = 'contract'\ntext = ''\n"),
            "4: kind = 'contract' is unknown; did you mean 'contact'?");
  EXPECT_EQ(LoadError(head + "kind = 'clear'\ntext = ''\ndistance = 1\n"),
            "6: unknown key 'distance'; did you mean 'distance_m'?");
  EXPECT_EQ(LoadError(head + "kind = 'stop_at'\ntext = ''\nobject = 'b'\ndistance_m = -1\n"),
            "7: distance_m = -1, allowed 0 .. 3000");
  EXPECT_THAT(LoadError(head + "kind = 'pass_gate'\ntext = ''\n"),
              HasSubstr("'object' is missing"));
}

TEST(LoadScenario, MissingFileIsNamed) {
  try {
    LoadScenario("/nowhere/at.toml");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "/nowhere/at.toml: no such scenario file");
  }
}

}  // namespace
}  // namespace eod::sim
