// Emergency stop, panic, faults of the box, and the only way back.
#include <gtest/gtest.h>

#include "tests/unit/canbridge/supervision_rig.h"

namespace eod::bridge {
namespace {

using dbc::BoxMessage;
using dbc::InhibitReason;
using dbc::SystemState;

void PressEstop(dbc::PanelState& panel) {
  panel.estop_a = false;
  panel.estop_b = true;
}

void ReleaseEstop(dbc::PanelState& panel) {
  panel.estop_a = true;
  panel.estop_b = false;
}

TEST(EmergencyStop, IsZeroInTheVeryFrameAndLatches) {
  SupervisionRig rig;
  rig.DriveForward();
  PressEstop(rig.panel);
  rig.Send(BoxMessage::kSafety);
  EXPECT_TRUE(rig.IsAtRest());
  EXPECT_EQ(rig.outcome().state, SystemState::kEstopLatched);
  EXPECT_EQ(rig.outcome().reason, InhibitReason::kEstop);
  EXPECT_TRUE(rig.outcome().estop_alarm);
  ReleaseEstop(rig.panel);
  rig.Release(1);
  rig.Run(milliseconds(1000));
  EXPECT_EQ(rig.outcome().state, SystemState::kEstopLatched);
}

TEST(EmergencyStop, PanicPositionLatchesAlike) {
  SupervisionRig rig;
  rig.DriveForward();
  rig.panel.deadman = dbc::Deadman::kPanic;
  rig.Send(BoxMessage::kSafety);
  EXPECT_TRUE(rig.IsAtRest());
  rig.Release(1);
  rig.panel.deadman = dbc::Deadman::kEnabled;
  rig.Run(milliseconds(100));
  EXPECT_EQ(rig.outcome().state, SystemState::kEstopLatched);
}

TEST(EmergencyStop, ResetAloneNeverMovesAndStartEndsIt) {
  SupervisionRig rig;
  rig.DriveForward();
  PressEstop(rig.panel);
  rig.Run(milliseconds(100));
  ReleaseEstop(rig.panel);
  rig.Release(1);
  rig.Run(milliseconds(100));
  rig.PressReset();
  EXPECT_EQ(rig.outcome().state, SystemState::kReady);
  EXPECT_FALSE(rig.outcome().estop_alarm);
  rig.Hold(1);
  rig.Run(milliseconds(1000));
  EXPECT_TRUE(rig.IsAtRest());
  rig.Release(1);
  rig.Run(milliseconds(40));
  rig.PressStart();
  rig.Hold(1);
  rig.Run(milliseconds(20));
  EXPECT_EQ(rig.forward(), 1.0);
}

TEST(EmergencyStop, ButtonHeldAtStartIsIgnoredUntilReleased) {
  SupervisionRig rig;
  rig.BringUp();
  PressEstop(rig.panel);
  rig.Run(milliseconds(40));
  ReleaseEstop(rig.panel);
  rig.Run(milliseconds(40));
  rig.PressReset();
  rig.Hold(1);
  rig.Run(milliseconds(40));
  rig.PressStart();
  EXPECT_EQ(rig.outcome().refusal, Refusal::kNeutralNeeded);
  rig.Release(1);
  rig.Run(milliseconds(40));
  EXPECT_TRUE(rig.is_permitted());
}

TEST(EmergencyStop, ResetIsRefusedWhilePressed) {
  SupervisionRig rig;
  rig.BringUp();
  PressEstop(rig.panel);
  rig.Run(milliseconds(40));
  rig.PressReset();
  ReleaseEstop(rig.panel);
  rig.Run(milliseconds(40));
  EXPECT_EQ(rig.outcome().state, SystemState::kEstopLatched);
}

TEST(EmergencyStop, ResetIsRefusedWhileAnyControlIsNotNeutral) {
  const auto is_still_latched = [](auto touch) {
    SupervisionRig rig;
    rig.BringUp();
    PressEstop(rig.panel);
    rig.Run(milliseconds(40));
    ReleaseEstop(rig.panel);
    touch(rig.panel);
    rig.Run(milliseconds(40));
    rig.PressReset();
    return rig.outcome().state == SystemState::kEstopLatched;
  };
  for (std::size_t m = 0; m < dbc::kMotionCount; ++m) {
    EXPECT_TRUE(is_still_latched([m](auto& panel) { panel.motion[m] = true; })) << m;
  }
  for (std::size_t a = 0; a < dbc::kAxisCount; ++a) {
    EXPECT_TRUE(is_still_latched([a](auto& panel) { panel.axis[a].value = -0.5; })) << a;
    EXPECT_TRUE(is_still_latched([a](auto& panel) { panel.axis[a].valid = false; })) << a;
  }
  EXPECT_FALSE(is_still_latched([](auto&) {})) << "the control experiment";
}

TEST(EmergencyStop, ResetCountsAsAnEdgeOnly) {
  SupervisionRig rig;
  rig.BringUp();
  PressEstop(rig.panel);
  rig.panel.reset = dbc::Button::kPressed;  // pressed before the release, and held
  rig.Run(milliseconds(40));
  ReleaseEstop(rig.panel);
  rig.Run(milliseconds(100));
  EXPECT_EQ(rig.outcome().state, SystemState::kEstopLatched);
}

TEST(EmergencyStop, StartCountsAsAnEdgeAfterResetOnly) {
  SupervisionRig rig;
  rig.BringUp();
  PressEstop(rig.panel);
  rig.Run(milliseconds(40));
  ReleaseEstop(rig.panel);
  rig.panel.start = dbc::Button::kPressed;
  rig.Run(milliseconds(40));
  rig.PressReset();
  rig.Run(milliseconds(40));
  EXPECT_EQ(rig.outcome().refusal, Refusal::kStartNeeded) << "held since before Reset";

  SupervisionRig both;
  both.BringUp();
  PressEstop(both.panel);
  both.Run(milliseconds(40));
  ReleaseEstop(both.panel);
  both.Run(milliseconds(40));
  both.panel.start = dbc::Button::kPressed;
  both.PressReset();
  EXPECT_EQ(both.outcome().refusal, Refusal::kStartNeeded) << "both in one frame";
}

TEST(EmergencyStop, ButtonChannelErrorsAreNoEdges) {
  SupervisionRig rig;
  rig.BringUp();
  PressEstop(rig.panel);
  rig.Run(milliseconds(40));
  ReleaseEstop(rig.panel);
  rig.Run(milliseconds(40));
  for (const dbc::Button bad : {dbc::Button::kError, dbc::Button::kNotAvailable}) {
    rig.panel.reset = bad;
    rig.Run(milliseconds(40));
    rig.panel.reset = dbc::Button::kPressed;  // not from Released
    rig.Run(milliseconds(40));
    EXPECT_EQ(rig.outcome().state, SystemState::kEstopLatched);
  }
}

TEST(EmergencyStop, EqualChannelsStopAtOnceAndLatchAfter60Milliseconds) {
  for (const bool level : {false, true}) {
    SupervisionRig rig;
    rig.DriveForward();  // at 340 ms
    rig.panel.estop_a = rig.panel.estop_b = level;
    rig.Send(BoxMessage::kSafety);
    EXPECT_TRUE(rig.IsAtRest());
    EXPECT_EQ(rig.outcome().refusal, Refusal::kEstopUnclear);
    rig.Run(milliseconds(60));
    EXPECT_FALSE(rig.outcome().box_fault_alarm);
    rig.Run(milliseconds(1));
    EXPECT_TRUE(rig.outcome().box_fault_alarm);
    EXPECT_EQ(rig.outcome().state, SystemState::kEstopLatched) << "treated as emergency stop";
    EXPECT_EQ(rig.outcome().reason, InhibitReason::kEstop);
  }
}

TEST(EmergencyStop, EqualChannelsThatPassInTimeNeedNeutralOnly) {
  SupervisionRig rig;
  rig.DriveForward();
  rig.panel.estop_b = true;
  rig.Run(milliseconds(60));  // frames at 360, 380 and 400 ms
  ReleaseEstop(rig.panel);
  rig.Run(milliseconds(20));  // healthy at 420 ms, 60 ms after the first
  rig.Run(milliseconds(100));
  EXPECT_EQ(rig.outcome().refusal, Refusal::kNeutralNeeded);
}

TEST(BoxFault, FaultByteAndButtonChannelLatch) {
  const auto state_after = [](auto break_box) {
    SupervisionRig rig;
    rig.DriveForward();
    dbc::PanelState healthy = rig.panel;
    break_box(rig.panel);
    rig.Run(milliseconds(20));
    EXPECT_TRUE(rig.IsAtRest());
    EXPECT_TRUE(rig.outcome().box_fault_alarm);
    healthy.motion = {};
    rig.panel = healthy;
    rig.Run(milliseconds(100));
    EXPECT_EQ(rig.outcome().refusal, Refusal::kBoxFault);
    rig.PressReset();
    return rig.outcome().refusal;
  };
  EXPECT_EQ(state_after([](auto& panel) { panel.box_fault = 7; }), Refusal::kStartNeeded);
  EXPECT_EQ(state_after([](auto& panel) { panel.button_channel_fault = true; }),
            Refusal::kStartNeeded);
}

}  // namespace
}  // namespace eod::bridge
