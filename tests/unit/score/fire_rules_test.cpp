// The rule of the arm key and that of two hands: rule 7 of 6.3 of the design.
#include <gtest/gtest.h>

#include "sim/disposal/disposal_status.h"
#include "tests/unit/score/judged.h"

namespace eod::sim {
namespace {

constexpr int kSafe = 1, kArmed = 2, kReleased = 1, kPressed = 2;

/// At the fire panel, with the key in safe.
struct FirePanelJudged : Judged {
  FirePanelJudged() { Panel(FireState::kSafe, kSafe); }
  void Panel(FireState state, int key, int left = kReleased, int right = kReleased) {
    sample.fire_state = static_cast<int>(state);
    sample.arm_key = key;
    sample.fire_left = left;
    sample.fire_right = right;
    Step();
  }
  int broken() const {
    return static_cast<int>((kRubric.safety - safety()) / ThePoints().fire_points + 0.5);
  }
};

TEST(FireRules, ShotByTheRulesCostsNothing) {
  FirePanelJudged run;
  run.Panel(FireState::kArmedWait, kArmed);
  run.Panel(FireState::kReady, kArmed);
  run.Panel(FireState::kReady, kArmed, kPressed);
  run.Panel(FireState::kReady, kArmed, kPressed, kPressed);
  for (int i = 0; i < 20; ++i) run.Panel(FireState::kFired, kArmed, kPressed, kPressed);
  for (int i = 0; i < 20; ++i) run.Panel(FireState::kFired, kArmed, kPressed);
  run.Panel(FireState::kSafe, kSafe);
  EXPECT_EQ(run.safety(), kRubric.safety);
}

TEST(FireRules, ButtonWithoutAReadyCircuitCostsOnceAPress) {
  for (const FireState state : {FireState::kSafe, FireState::kArmedWait, FireState::kFault}) {
    FirePanelJudged run;
    for (int i = 0; i < 20; ++i) run.Panel(state, kArmed, kPressed);
    EXPECT_EQ(run.broken(), 1);
    run.Panel(state, kArmed);
    run.Panel(state, kArmed, kReleased, kPressed);
    EXPECT_EQ(run.broken(), 2);
    EXPECT_EQ(EventsOf(run.dut, ScoreMark::kFireButton).size(), 2u);
  }
}

TEST(FireRules, OneHandAloneCostsAfterTheTimeForTheOther) {
  FirePanelJudged run;
  run.Panel(FireState::kReady, kArmed);
  const int in_time = static_cast<int>(TheRules().disrupter.both_within / Judged::kStep + 0.5);
  for (int i = 0; i < in_time; ++i) run.Panel(FireState::kReady, kArmed, kReleased, kPressed);
  EXPECT_EQ(run.broken(), 0);
  for (int i = 0; i < 20; ++i) run.Panel(FireState::kReady, kArmed, kReleased, kPressed);
  EXPECT_EQ(run.broken(), 1);
  EXPECT_EQ(run.dut.Sheet().events.at(0).text, "Right fire button held alone");
}

TEST(FireRules, ArmedOnTheMoveCostsOnceAnArming) {
  FirePanelJudged run;
  run.sample.arm_key = kArmed;
  run.Drive(0.5);
  run.Wait(1);
  run.Drive(0.5);
  EXPECT_EQ(run.broken(), 1);
  run.Panel(FireState::kSafe, kSafe);
  run.sample.arm_key = kArmed;
  run.sample.turn_rate_dps = 5;
  run.Step();
  EXPECT_EQ(run.broken(), 2);
}

TEST(FireRules, ArmingUntilItTimesOutCosts) {
  FirePanelJudged run;
  run.Panel(FireState::kReady, kArmed);
  for (int i = 0; i < 5; ++i) run.Panel(FireState::kTimeOut, kArmed);
  EXPECT_EQ(run.broken(), 1);
}

}  // namespace
}  // namespace eod::sim
