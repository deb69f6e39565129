#include "recorder/run_observer.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eod::recorder {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

// Simulation starts at 100 s of Unix time, one step every 4 ms.
TimePoint AtStep(int step) {
  return TimePoint{std::chrono::seconds(100)} + std::chrono::milliseconds(4 * step);
}
TimePoint At(double t) { return AtStep(static_cast<int>(std::lround(t * 250))); }

class RunObserverTest : public testing::Test {
 protected:
  // Robot states and pictures (25 a second) until `t`.
  void RunUntil(double t) {
    for (; step_ * 0.004 <= t; ++step_) {
      RobotStateSeen state;
      state.time = AtStep(step_);
      state.step = step_;
      state.module = 1;
      dut_.OnRobotState(state.time, state);
      if (step_ % 10 == 0) dut_.OnPicture(Camera::kDrive, state.time, 640, 480, {1});
    }
  }

  void Mission(MissionState state, int step = 0) {
    dut_.OnMission({state, 1, step, 2, step == 0 ? "Touch the wall" : "Back off"});
  }

  int step_ = 0;
  RunObserver dut_;
};

TEST_F(RunObserverTest, CountsFromTheFirstRobotState) {
  RunUntil(10);
  const Summary summary = dut_.Summarize();
  EXPECT_EQ(summary.module, "flat");
  EXPECT_NEAR(summary.sim_seconds, 10, 1e-9);
  EXPECT_NEAR(summary.step.period_ms, 4, 1e-9);
  EXPECT_EQ(summary.camera.frames, 251);
  EXPECT_NEAR(summary.camera.fps, 25, 1e-9);
  EXPECT_EQ(summary.camera.width, 640);
}

TEST_F(RunObserverTest, ListsRaisedAlarmsOnly) {
  RunUntil(10);
  dut_.OnAlarm({At(9.5), 0x10, true, 3});
  dut_.OnAlarm({At(9.9), 0x10, false, 3});
  const Summary summary = dut_.Summarize();
  ASSERT_THAT(summary.alarms, SizeIs(1));
  EXPECT_NEAR(summary.alarms[0].t, 9.5, 1e-9);
  EXPECT_EQ(summary.alarms[0].code, 0x10);
  EXPECT_EQ(summary.alarms[0].parts, 3U);
}

TEST_F(RunObserverTest, SucceedsWhenMissionAndScriptDo) {
  RunUntil(1);
  dut_.OnPanel({"hold M01 for 2s", false, false});
  Mission(MissionState::kRun);
  EXPECT_EQ(dut_.Summarize().result, "incomplete");
  Mission(MissionState::kSuccess, 2);
  EXPECT_TRUE(dut_.mission_ended());
  EXPECT_EQ(dut_.Summarize().result, "incomplete") << "the script has not finished";
  dut_.OnPanel({"", true, false});
  EXPECT_EQ(dut_.Summarize().result, "success");
}

TEST_F(RunObserverTest, NeedsNoScriptToSucceed) {
  RunUntil(1);
  Mission(MissionState::kRun);
  Mission(MissionState::kSuccess, 2);
  EXPECT_EQ(dut_.Summarize().result, "success");
}

TEST_F(RunObserverTest, KeepsTheOutcomeWhenTheMissionGoesIdle) {
  RunUntil(1);
  Mission(MissionState::kRun);
  Mission(MissionState::kSuccess, 2);
  Mission(MissionState::kIdle);
  EXPECT_EQ(dut_.Summarize().result, "success");
}

TEST_F(RunObserverTest, FailsWithTheMission) {
  RunUntil(1);
  Mission(MissionState::kRun);
  Mission(MissionState::kAbort);
  EXPECT_EQ(dut_.Summarize().result, "fail");
}

TEST_F(RunObserverTest, FailsWithTheScriptEvenAfterTheMission) {
  RunUntil(1);
  Mission(MissionState::kRun);
  Mission(MissionState::kSuccess, 2);
  dut_.OnPanel({"", true, true});
  EXPECT_EQ(dut_.Summarize().result, "fail");
}

TEST_F(RunObserverTest, AMissionThatStartsAgainHasNoOutcomeYet) {
  RunUntil(1);
  Mission(MissionState::kRun);
  Mission(MissionState::kFail);
  Mission(MissionState::kRun);
  EXPECT_EQ(dut_.Summarize().result, "incomplete");
}

TEST_F(RunObserverTest, TellsTheStoryInMoments) {
  RunUntil(5);
  Mission(MissionState::kRun, 0);
  RunUntil(15);
  dut_.OnAlarm({At(15), 0x10, true, 1});
  Mission(MissionState::kRun, 1);
  RunUntil(19);
  dut_.OnAlarm({At(19), 0x10, false, 1});
  RunUntil(25);
  Mission(MissionState::kSuccess, 2);
  RunUntil(28);
  dut_.OnAlarm({At(28), 0x80, true, 0});
  RunUntil(30);
  std::vector<std::string> labels;
  for (const Moment& moment : dut_.TellingMoments(6)) labels.push_back(moment.label);
  EXPECT_THAT(labels,
              ElementsAre("Mission starts", "Before the contact", "Contact: front left wheel",
                          "Back off", "\u2713 Back off", "E-stop"));
}

TEST_F(RunObserverTest, ShowsPicturesThatStoppedAsStopped) {
  RunUntil(2);
  EXPECT_NEAR(dut_.live().camera_fps, 25, 1);
  for (const int last = step_ + 500; step_ < last; ++step_) {
    RobotStateSeen state;
    state.time = AtStep(step_);
    state.step = step_;
    dut_.OnRobotState(state.time, state);
  }
  EXPECT_EQ(dut_.live().camera_fps, 0);
}

}  // namespace
}  // namespace eod::recorder
