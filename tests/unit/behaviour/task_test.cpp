#include "sim/task/task.h"

#include <gtest/gtest.h>

#include "tests/unit/behaviour/mission_under_way.h"

namespace eod::sim {
namespace {

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

TEST(Task, ContactWithTheWrongObjectIsACollisionAndNoStep) {
  Mission dut({StepOf(TaskStep::Kind::kContact, "wall"), StepOf(TaskStep::Kind::kContact, "wall")});
  dut.inputs.in_contact = dut.inputs.new_contact = true;
  dut.inputs.contact_object = "board";
  EXPECT_EQ(dut.Step().step, 0);
  dut.inputs.contact_object = "wall";
  const TaskStatus status = dut.Step();
  EXPECT_EQ(status.step, 1);
  EXPECT_EQ(status.collisions, 2);
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

}  // namespace
}  // namespace eod::sim
