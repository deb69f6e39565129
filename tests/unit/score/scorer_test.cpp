#include "sim/score/scorer.h"

#include <gtest/gtest.h>

#include "tests/unit/score/judged.h"

namespace eod::sim {
namespace {

TEST(Scorer, GivesNothingBeforeAMissionStarts) {
  Scorer dut(TwoSteps(), Yard(), TheRules());
  ScoreSample sample;
  sample.module = 3;
  dut.Advance(sample);
  EXPECT_FALSE(dut.has_started());
  EXPECT_EQ(dut.total(), 0);
  EXPECT_EQ(dut.Sheet().result, "idle");
}

TEST(Scorer, PerfectMissionHasAHundredPointsAndPasses) {
  Judged run;
  run.Wait(50);
  run.Succeed();
  EXPECT_DOUBLE_EQ(run.dut.total(), 100);
  EXPECT_TRUE(run.dut.Sheet().passed);
  EXPECT_TRUE(run.dut.is_over());
}

TEST(Scorer, StepsCountByTheirWeightsAndOnlyWhenComplete) {
  Scenario scenario = TwoSteps();
  scenario.steps[0].weight = 3;
  Judged run(scenario);
  run.Step();
  EXPECT_EQ(run.dut.points()[0], 0);
  run.CompleteStep();
  EXPECT_DOUBLE_EQ(run.dut.points()[0], kRubric.steps * 3 / 4);
  EXPECT_DOUBLE_EQ(EventsOf(run.dut, ScoreMark::kStep).at(0).points, kRubric.steps * 3 / 4);
  run.CompleteStep();
  EXPECT_DOUBLE_EQ(run.dut.points()[0], kRubric.steps);
}

TEST(Scorer, TimeIsFullAtParAndGoneAtTwiceParAndNothingWithoutSuccess) {
  const auto time_after = [](double seconds) {
    Judged run;
    run.Wait(seconds - Judged::kStep);
    EXPECT_EQ(run.time(), 0);
    run.Succeed();
    return run.time();
  };
  const double par = TwoSteps().par_time_s;
  ASSERT_EQ(ThePoints().time_zero, 2);
  EXPECT_NEAR(time_after(par), kRubric.time, 1e-9);
  EXPECT_NEAR(time_after(1.5 * par), kRubric.time / 2, 1e-9);
  EXPECT_NEAR(time_after(2 * par), 0, 1e-9);
  EXPECT_NEAR(time_after(2.5 * par), 0, 1e-9);
  Judged aborted;
  aborted.End(MissionState::kAbort);
  EXPECT_EQ(aborted.time(), 0);
}

TEST(Scorer, ScenarioSharesThePartsAsItsRubricSays) {
  Scenario scenario = TwoSteps();
  scenario.rubric = {
      .steps = 50, .safety = 20, .precision = 10, .time = 15, .economy = 5, .pass = 90};
  Judged run(scenario);
  run.sample.contact_parts = 1;
  run.Step();
  run.sample.contact_parts = 0;
  run.Succeed();
  const ScoreSheet sheet = run.dut.Sheet();
  EXPECT_DOUBLE_EQ(sheet.total, 100 - ThePoints().collision_points);
  EXPECT_EQ(sheet.pass, 90);
  EXPECT_DOUBLE_EQ(sheet.parts[0].points, 50);
  EXPECT_DOUBLE_EQ(sheet.parts[3].points, 15);
}

TEST(Scorer, CriticalFailureFailsWhateverThePoints) {
  Scenario scenario = TwoSteps();
  scenario.rubric.pass = 10;
  Judged run(scenario);
  run.CompleteStep();
  run.End(MissionState::kFail, FailReason::kRollover);
  const ScoreSheet sheet = run.dut.Sheet();
  EXPECT_GT(sheet.total, sheet.pass);
  EXPECT_FALSE(sheet.passed);
  EXPECT_EQ(sheet.result, "fail");
  EXPECT_EQ(sheet.critical_failure, "rollover");
  EXPECT_EQ(sheet.events.back().text, "Mission failed: rollover");
}

TEST(Scorer, TooFewPointsDoNotPass) {
  Judged run;
  run.sample.wanted_mask = run.sample.blocked_mask = 1;
  run.Wait(250);  // safety is gone, and so is time
  run.Succeed();
  EXPECT_DOUBLE_EQ(run.dut.total(), kRubric.steps + kRubric.precision + kRubric.economy);
  EXPECT_FALSE(run.dut.Sheet().passed);
}

TEST(Scorer, HoldsItsResultUntilTheNextMissionStarts) {
  Judged run;
  run.sample.contact_parts = 1;
  run.Step();
  run.Succeed();
  const ScoreSheet held = run.dut.Sheet();
  run.sample.contact_parts = 2;
  run.Tell();
  run.sample.mission_state = static_cast<int>(MissionState::kIdle);
  run.Tell();
  EXPECT_EQ(run.dut.Sheet(), held);
  run.sample.contact_parts = 0;
  run.sample.mission_state = static_cast<int>(MissionState::kRun);
  run.sample.mission_s = 0;
  run.sample.mission_step = 0;
  run.Tell();
  EXPECT_FALSE(run.dut.is_over());
  EXPECT_EQ(run.dut.events().size(), 0u);
  EXPECT_DOUBLE_EQ(run.safety(), kRubric.safety);
}

TEST(Scorer, LeavingTheModuleLeavesTheMissionIncomplete) {
  Judged run;
  run.CompleteStep();
  run.sample.module = 1;
  run.sample.mission_state = static_cast<int>(MissionState::kIdle);
  run.Tell();
  EXPECT_TRUE(run.dut.is_over());
  EXPECT_EQ(run.dut.Sheet().result, "incomplete");
}

TEST(Scorer, PauseTakesNoTimeAndCostsNothing) {
  Judged run;
  run.sample.wanted_mask = run.sample.blocked_mask = 1;
  for (int i = 0; i < 100; ++i) run.Tell();
  EXPECT_DOUBLE_EQ(run.safety(), kRubric.safety);
}

TEST(Scorer, SaysWhatItDidNotSee) {
  Judged run;
  run.Wait(1);
  EXPECT_EQ(run.dut.Sheet().lost_s, 0);
  run.sample.step += 5;
  run.sample.mission_s += 0.5;
  run.Step();
  EXPECT_NEAR(run.dut.Sheet().lost_s, 0.6, 1e-9);
  Scorer late(TwoSteps(), Yard(), TheRules());
  late.Advance(run.sample);
  EXPECT_DOUBLE_EQ(late.Sheet().lost_s, run.sample.mission_s);
}

TEST(Scorer, TracksTheWayInTheModulesFrame) {
  Judged run;
  run.Drive(30);
  const ScoreSheet sheet = run.dut.Sheet();
  ASSERT_GT(sheet.track.size(), 100u);
  EXPECT_EQ(sheet.track.front(), Eigen::Vector2d(0, 0));
  EXPECT_NEAR(sheet.track.back().y(), 30, 0.1);
  EXPECT_EQ(sheet.track.back().x(), 0);
}

TEST(Track, GivesUpEverySecondPointWhenItIsFull) {
  Track dut;
  for (int i = 0; i <= 100'000; ++i) dut.Add({0.01 * i, 0});
  EXPECT_LE(dut.points().size(), Track::kRoom);
  EXPECT_GT(dut.points().size(), Track::kRoom / 2 - 1);
  EXPECT_EQ(dut.points().front().x(), 0);
  EXPECT_NEAR(dut.points().back().x(), 1000, 3);
}

}  // namespace
}  // namespace eod::sim
