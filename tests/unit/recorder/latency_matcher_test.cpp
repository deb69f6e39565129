#include "recorder/latency_matcher.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eod::recorder {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::IsEmpty;

TimePoint At(int64_t us) { return TimePoint{std::chrono::microseconds(us)}; }

LatencyMatcher::Buttons Held(int motion) {
  LatencyMatcher::Buttons held{};
  if (motion > 0) held[static_cast<size_t>(motion - 1)] = true;
  return held;
}

RobotStateSeen StateAt(double y_m, uint32_t inhibit_mask = 0) {
  RobotStateSeen state;
  state.position_m = {0, y_m, 0};
  state.inhibit_mask = inhibit_mask;
  return state;
}

// A robot that stands still, a permitted operator, no button held.
class ButtonToPose : public testing::Test {
 protected:
  ButtonToPose() {
    dut_.OnMotionPermitted(true);
    dut_.OnMotionFrame(At(0), Held(0));
    dut_.OnRobotState(At(0), StateAt(0));
    dut_.OnRobotState(At(4000), StateAt(0));
  }
  LatencyMatcher dut_;
};

TEST_F(ButtonToPose, RunsFromTheFrameToTheFirstMovedState) {
  dut_.OnMotionFrame(At(5000), Held(1));
  dut_.OnRobotState(At(8000), StateAt(0));
  dut_.OnRobotState(At(12'000), StateAt(16e-6));
  dut_.OnRobotState(At(16'000), StateAt(50e-6));
  // 12.0 - 5.0 ms
  EXPECT_THAT(dut_.button_to_pose_ms(), ElementsAre(DoubleEq(7.0)));
}

TEST_F(ButtonToPose, TakesAJointForAPose) {
  dut_.OnMotionFrame(At(5000), Held(9));
  RobotStateSeen raised = StateAt(0);
  raised.joint[2] = 0.01;
  dut_.OnRobotState(At(6500), raised);
  EXPECT_THAT(dut_.button_to_pose_ms(), ElementsAre(DoubleEq(1.5)));
}

TEST_F(ButtonToPose, TakesNoSampleWhileTheRobotMovesAlready) {
  dut_.OnRobotState(At(8000), StateAt(0.001));
  dut_.OnMotionFrame(At(9000), Held(1));
  dut_.OnRobotState(At(12'000), StateAt(0.002));
  EXPECT_THAT(dut_.button_to_pose_ms(), IsEmpty());
}

TEST_F(ButtonToPose, TakesNoSampleWithoutPermission) {
  dut_.OnMotionPermitted(false);
  dut_.OnMotionFrame(At(5000), Held(1));
  dut_.OnRobotState(At(8000), StateAt(0.001));
  EXPECT_THAT(dut_.button_to_pose_ms(), IsEmpty());
}

TEST_F(ButtonToPose, TakesNoSampleOfAnInhibitedMotion) {
  dut_.OnRobotState(At(8000), StateAt(0, 0b1));
  dut_.OnMotionFrame(At(9000), Held(1));
  dut_.OnRobotState(At(12'000), StateAt(0.001, 0b1));
  EXPECT_THAT(dut_.button_to_pose_ms(), IsEmpty());
}

TEST_F(ButtonToPose, TakesTheWayBackWhileForwardIsInhibited) {
  dut_.OnRobotState(At(8000), StateAt(0, 0b1));
  dut_.OnMotionFrame(At(9000), Held(2));
  dut_.OnRobotState(At(12'000), StateAt(-0.001, 0b1));
  EXPECT_THAT(dut_.button_to_pose_ms(), ElementsAre(DoubleEq(3.0)));
}

TEST_F(ButtonToPose, ForgetsAPressThatWasGivenUp) {
  dut_.OnMotionFrame(At(5000), Held(1));
  dut_.OnMotionFrame(At(6000), Held(0));
  dut_.OnRobotState(At(8000), StateAt(0.001));
  EXPECT_THAT(dut_.button_to_pose_ms(), IsEmpty());
  EXPECT_EQ(dut_.unanswered_presses(), 0);
}

TEST_F(ButtonToPose, CountsAPressThatMovedNothing) {
  dut_.OnMotionFrame(At(5000), Held(1));
  dut_.OnRobotState(At(1'006'000), StateAt(0));
  EXPECT_EQ(dut_.unanswered_presses(), 1);
  dut_.OnRobotState(At(1'010'000), StateAt(0.001));
  EXPECT_THAT(dut_.button_to_pose_ms(), IsEmpty());
}

TEST_F(ButtonToPose, TakesAHeldButtonOnce) {
  dut_.OnMotionFrame(At(5000), Held(1));
  dut_.OnRobotState(At(8000), StateAt(0.001));
  dut_.OnRobotState(At(12'000), StateAt(0.001));
  dut_.OnMotionFrame(At(15'000), Held(1));
  dut_.OnRobotState(At(16'000), StateAt(0.002));
  EXPECT_THAT(dut_.button_to_pose_ms(), ElementsAre(DoubleEq(3.0)));
}

TEST(LatencyMatcher, TakesNoButtonThatIsHeldFromTheStart) {
  LatencyMatcher dut;
  dut.OnMotionPermitted(true);
  dut.OnRobotState(At(0), StateAt(0));
  dut.OnRobotState(At(4000), StateAt(0));
  dut.OnMotionFrame(At(5000), Held(1));
  dut.OnRobotState(At(8000), StateAt(0.001));
  EXPECT_THAT(dut.button_to_pose_ms(), IsEmpty());
}

TEST(ContactToLamp, RunsFromTheStepToTheFirstLampFrame) {
  LatencyMatcher dut;
  dut.OnAlarmFrame(At(0), false);
  dut.OnCollisionAlarm(At(10'000), true);
  dut.OnAlarmFrame(At(11'250), true);
  dut.OnAlarmFrame(At(111'250), true);
  EXPECT_THAT(dut.contact_to_lamp_ms(), ElementsAre(DoubleEq(1.25)));
}

TEST(ContactToLamp, DoesNotMindWhichMessageIsSeenFirst) {
  LatencyMatcher dut;
  dut.OnAlarmFrame(At(0), false);
  dut.OnAlarmFrame(At(11'250), true);
  dut.OnCollisionAlarm(At(10'000), true);
  EXPECT_THAT(dut.contact_to_lamp_ms(), ElementsAre(DoubleEq(1.25)));
}

TEST(ContactToLamp, TakesNoSampleWhileTheLampIsOnAlready) {
  LatencyMatcher dut;
  dut.OnAlarmFrame(At(5000), true);
  dut.OnCollisionAlarm(At(10'000), true);
  dut.OnAlarmFrame(At(15'000), true);
  EXPECT_THAT(dut.contact_to_lamp_ms(), IsEmpty());
}

TEST(ContactToLamp, TakesNoSampleOfAContactThatEndedUnseen) {
  LatencyMatcher dut;
  dut.OnAlarmFrame(At(0), false);
  dut.OnCollisionAlarm(At(10'000), true);
  dut.OnCollisionAlarm(At(14'000), false);
  dut.OnAlarmFrame(At(50'000), true);
  EXPECT_THAT(dut.contact_to_lamp_ms(), IsEmpty());
}

}  // namespace
}  // namespace eod::recorder
