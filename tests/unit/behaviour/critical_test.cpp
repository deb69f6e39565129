// What ends an exercise at once, and what a scenario leaves out of that.
#include <gtest/gtest.h>

#include "tests/unit/behaviour/mission_under_way.h"

namespace eod::sim {
namespace {

constexpr CriticalRules kCritical{.link_lost = 30, .bomb_below = -1};

/// Two charges in a yard of 20 m by 40 m, and a mission of one step that is far away.
struct Exercise {
  RobotState state;
  DisposalStatus disposal;
  std::vector<Eigen::Isometry3d> X_MO;
  TaskInputs inputs;
  Task task;

  explicit Exercise(const Scenario& scenario = {}) : task(WithStep(scenario), Yard(), kCritical) {
    for (const MovableObject& charge : Yard().movables) X_MO.push_back(charge.X_MO);
    inputs.dt_s = 0.1;
    inputs.state = &state;
    inputs.disposal = &disposal;
    inputs.movables = X_MO;
    inputs.started = true;
    Step();
    inputs.started = false;
  }
  Exercise(const Exercise&) = delete;
  Exercise& operator=(const Exercise&) = delete;

  static ModuleModel Yard() {
    ModuleModel module = Flat();
    module.half_size = Eigen::Vector2d(10, 20);
    for (const double y : {6.0, 9.0}) {
      MovableObject charge;
      charge.name = y < 7 ? "near" : "far";
      charge.explosive = ExplosiveSpec{.radius = 0.06, .half_height = 0.12};
      charge.X_MO.translation() = Eigen::Vector3d(0, y, 0.12);
      module.movables.push_back(charge);
    }
    return module;
  }

  TaskStatus Step() { return task.Advance(inputs); }
  FailReason Reason() { return Step().fail_reason; }

 private:
  static Scenario WithStep(Scenario scenario) {
    TaskStep far_away = StepOf(TaskStep::Kind::kReach, "");
    far_away.x = 9;
    if (scenario.steps.empty()) scenario.steps = {far_away};
    return scenario;
  }
};

Scenario WithArea() {
  Scenario scenario;
  scenario.area = {{-2, -2}, {2, -2}, {2, 7}, {0, 4}, {-2, 7}};
  return scenario;
}

TEST(Critical, LeavingTheModulesAreaFails) {
  Exercise dut;
  dut.state.position = {9.9, 19.9, 0};
  EXPECT_EQ(dut.Reason(), FailReason::kNone);
  dut.state.position = {9.9, 20.1, 0};
  EXPECT_EQ(dut.Reason(), FailReason::kOutOfArea);
  EXPECT_EQ(dut.task.status().state, MissionState::kFail);
}

TEST(Critical, ThePolygonOfTheScenarioIsTheAreaEvenWhereItIsConcave) {
  Exercise dut(WithArea());
  dut.state.position = {-1.8, 6, 0};
  EXPECT_EQ(dut.Reason(), FailReason::kNone);
  dut.state.position = {0, 4.5, 0};  // in the notch
  EXPECT_EQ(dut.Reason(), FailReason::kOutOfArea);
}

TEST(Critical, AChargeThatLeavesTheAreaOrFallsOffTheWorldIsLost) {
  Exercise carried;
  carried.X_MO[0].translation() = Eigen::Vector3d(10.1, 6, 0.8);
  EXPECT_EQ(carried.Reason(), FailReason::kBombLost);
  Exercise fallen;
  fallen.X_MO[1].translation().z() = -0.9;
  EXPECT_EQ(fallen.Reason(), FailReason::kNone);
  fallen.X_MO[1].translation().z() = -1.1;
  EXPECT_EQ(fallen.Reason(), FailReason::kBombLost);
}

TEST(Critical, AChargeThatStoodOutsideFromTheStartIsNoOnesBusiness) {
  // Both are beyond y = 4 on x = 0, in the notch.
  Exercise dut(WithArea());
  EXPECT_EQ(dut.Reason(), FailReason::kNone);
}

TEST(Critical, LinkIsLostWhenItHasBeenSilentForLong) {
  Exercise dut;
  dut.inputs.link_lost_s = 29.9;
  EXPECT_EQ(dut.Reason(), FailReason::kNone);
  dut.inputs.link_lost_s = 30;
  EXPECT_EQ(dut.Reason(), FailReason::kLinkLost);
}

TEST(Critical, TheInstructorStopsAndEnds) {
  Exercise stopped;
  stopped.inputs.estopped = true;
  EXPECT_EQ(stopped.Reason(), FailReason::kEstop);
  Exercise ended;
  ended.inputs.ended_by_instructor = true;
  EXPECT_EQ(ended.Reason(), FailReason::kInstructor);
}

TEST(Critical, AScenarioLeavesOutWhatItDoesNotCallCritical) {
  Scenario scenario;
  scenario.critical = SetOf(FailReason::kOutOfArea) | SetOf(FailReason::kInstructor);
  Exercise dut(scenario);
  dut.inputs.rolled_over = true;
  dut.inputs.estopped = true;
  dut.inputs.link_lost_s = 100;
  dut.disposal.detonation = DetonationCause::kDropped;
  dut.X_MO[0].translation().z() = -5;
  EXPECT_EQ(dut.Reason(), FailReason::kNone);
  dut.state.position.x() = 11;
  EXPECT_EQ(dut.Reason(), FailReason::kOutOfArea);
}

Scenario NearBeforeFar(bool strict) {
  Scenario scenario;
  scenario.steps = {StepOf(TaskStep::Kind::kGrasp, "near"), StepOf(TaskStep::Kind::kGrasp, "far")};
  scenario.steps[1].strict = strict;
  return scenario;
}

TEST(Critical, AStrictStepBeforeItsTurnIsTheWrongOrder) {
  Exercise dut(NearBeforeFar(true));
  dut.disposal.held_body = 1;
  EXPECT_EQ(dut.Reason(), FailReason::kWrongOrder);
  Exercise lenient(NearBeforeFar(false));
  lenient.disposal.held_body = 1;
  EXPECT_EQ(lenient.Reason(), FailReason::kNone);
}

TEST(Critical, AStrictStepInItsTurnSucceeds) {
  Exercise dut(NearBeforeFar(true));
  dut.disposal.held_body = 0;
  EXPECT_EQ(dut.Reason(), FailReason::kNone);
  dut.disposal.held_body = 1;
  EXPECT_EQ(dut.Step().state, MissionState::kSuccess);
}

TEST(Inspection, WantsTheObjectInTheShownPictureForItsTime) {
  Scenario scenario;
  TaskStep look = StepOf(TaskStep::Kind::kInspect, "board", 5);
  look.time = 0.5;
  scenario.steps = {look};
  Exercise dut(scenario);
  ASSERT_TRUE(dut.task.inspected());
  EXPECT_EQ(dut.task.inspected()->step->object, "board");
  dut.inputs.sees_object = true;
  for (int i = 0; i < 4; ++i) EXPECT_EQ(dut.Step().state, MissionState::kRun);
  dut.inputs.sees_object = false;  // it begins anew
  dut.Step();
  dut.inputs.sees_object = true;
  for (int i = 0; i < 4; ++i) EXPECT_EQ(dut.Step().state, MissionState::kRun);
  EXPECT_EQ(dut.Step().state, MissionState::kSuccess);
  EXPECT_FALSE(dut.task.inspected());
}

}  // namespace
}  // namespace eod::sim
