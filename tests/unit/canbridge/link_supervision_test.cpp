// The rules of motion: what must hold, what stops, what latches, what starts again.
#include "canbridge/link_supervision.h"

#include <gtest/gtest.h>

#include "tests/unit/canbridge/supervision_rig.h"

namespace eod::bridge {
namespace {

using dbc::BoxMessage;
using dbc::InhibitReason;
using dbc::SystemState;

// Motion only while every rule holds.

TEST(LinkSupervision, MovesWhenEveryRuleHolds) {
  SupervisionRig rig;
  rig.DriveForward();
  EXPECT_TRUE(rig.is_permitted());
  EXPECT_EQ(rig.forward(), 1.0);
  EXPECT_EQ(rig.outcome().state, SystemState::kOperate);
  EXPECT_EQ(rig.outcome().reason, InhibitReason::kNone);
  EXPECT_EQ(rig.outcome().inhibit_mask, 0U);
}

TEST(LinkSupervision, BeginsInStandbyWithoutABox) {
  SupervisionRig rig;
  rig.sends_safety = rig.sends_motion = rig.sends_axes = rig.sends_heartbeat = false;
  rig.Run(milliseconds(1000));
  EXPECT_EQ(rig.outcome().state, SystemState::kStandby);
  EXPECT_EQ(rig.outcome().refusal, Refusal::kNoBox);
  EXPECT_FALSE(rig.outcome().link_alarm) << "nothing was lost yet";
}

TEST(LinkSupervision, MovesOnlyWithTheKeyAtOperate) {
  for (const dbc::KeySwitch key : {dbc::KeySwitch::kOff, dbc::KeySwitch::kStandby,
                                   dbc::KeySwitch::kMaintenance, dbc::KeySwitch::kNotAvailable}) {
    SupervisionRig rig;
    rig.DriveForward();
    rig.panel.key = key;
    rig.Send(BoxMessage::kSafety);
    EXPECT_TRUE(rig.IsAtRest());
    EXPECT_EQ(rig.outcome().state, SystemState::kStandby);
    EXPECT_EQ(rig.outcome().reason, InhibitReason::kNotReady);
  }
}

TEST(LinkSupervision, MovesOnlyWhileTheEnablingSwitchIsHeld) {
  for (const dbc::Deadman deadman : {dbc::Deadman::kReleased, dbc::Deadman::kNotAvailable}) {
    SupervisionRig rig;
    rig.DriveForward();
    rig.panel.deadman = deadman;
    rig.Send(BoxMessage::kSafety);
    EXPECT_TRUE(rig.IsAtRest()) << "at once, without a ramp";
    EXPECT_EQ(rig.outcome().state, SystemState::kReady);
    EXPECT_EQ(rig.outcome().reason, InhibitReason::kDeadman);
    EXPECT_EQ(rig.outcome().inhibit_mask, 1U) << "M01 is wanted and refused";
  }
}

TEST(LinkSupervision, MovesOnlyWhenTheHeartbeatSaysOperational) {
  for (const dbc::NmtState nmt : {dbc::NmtState::kBootUp, dbc::NmtState::kStopped,
                                  dbc::NmtState::kPreOperational, dbc::NmtState::kUnknown}) {
    SupervisionRig rig;
    rig.DriveForward();
    rig.panel.nmt = nmt;
    rig.Send(BoxMessage::kHeartbeat);
    EXPECT_TRUE(rig.IsAtRest());
    EXPECT_EQ(rig.outcome().refusal, Refusal::kNotOperational);
  }
}

TEST(LinkSupervision, NeverMovesWithoutAHeartbeat) {
  SupervisionRig rig;
  rig.sends_heartbeat = false;
  rig.DriveForward();
  EXPECT_FALSE(rig.is_permitted());
  EXPECT_EQ(rig.outcome().refusal, Refusal::kNoBox);
}

TEST(LinkSupervision, HeartbeatMayBe600MillisecondsOldAndNotMore) {
  SupervisionRig rig;
  rig.DriveForward();  // at 340 ms; the last heartbeat was at 200 ms
  rig.sends_heartbeat = false;
  rig.Run(milliseconds(460));  // 800 ms: age 600 ms
  EXPECT_TRUE(rig.is_permitted());
  rig.Run(milliseconds(1));
  EXPECT_FALSE(rig.is_permitted());
  EXPECT_EQ(rig.outcome().state, SystemState::kSafeStop);
  EXPECT_EQ(rig.outcome().refusal, Refusal::kHeartbeatLost);
}

TEST(LinkSupervision, MovesOnlyWithSafetyAndMotionFrames) {
  for (bool SupervisionRig::*frames :
       {&SupervisionRig::sends_safety, &SupervisionRig::sends_motion}) {
    SupervisionRig rig;
    rig.*frames = false;
    rig.DriveForward();
    EXPECT_FALSE(rig.is_permitted());
  }
}

TEST(LinkSupervision, MovesWithoutABoxThatHasSticks) {
  SupervisionRig rig;
  rig.sends_axes = false;
  rig.DriveForward();
  EXPECT_TRUE(rig.is_permitted());
}

TEST(LinkSupervision, RefusesSignalsThatAreNotAvailable) {
  const auto refused = [](auto break_signal) {
    SupervisionRig rig;
    rig.DriveForward();
    break_signal(rig.panel);
    rig.Run(milliseconds(20));
    return rig.IsAtRest() && rig.outcome().refusal == Refusal::kSignalInvalid;
  };
  EXPECT_TRUE(refused([](auto& panel) { panel.mode = dbc::ControlMode::kNotAvailable; }));
  EXPECT_TRUE(refused([](auto& panel) { panel.speed_range = dbc::SpeedRange::kNotAvailable; }));
  EXPECT_TRUE(refused([](auto& panel) { panel.axis[2].valid = false; }));
}

// Neutral since the last stop.

TEST(LinkSupervision, ButtonHeldAtPowerUpIsIgnoredUntilReleased) {
  SupervisionRig rig;
  rig.Hold(1);
  rig.BringUp();
  EXPECT_TRUE(rig.IsAtRest());
  EXPECT_EQ(rig.outcome().reason, InhibitReason::kNeutralNeeded);
  rig.Release(1);
  rig.Run(milliseconds(20));
  rig.Hold(1);
  rig.Run(milliseconds(20));
  EXPECT_EQ(rig.forward(), 1.0);
}

TEST(LinkSupervision, ButtonHeldThroughAStopDoesNotStartAgain) {
  SupervisionRig rig;
  rig.DriveForward();
  rig.panel.deadman = dbc::Deadman::kReleased;
  rig.Run(milliseconds(40));
  rig.panel.deadman = dbc::Deadman::kEnabled;
  rig.Run(milliseconds(40));
  EXPECT_TRUE(rig.IsAtRest());
  EXPECT_EQ(rig.outcome().reason, InhibitReason::kNeutralNeeded);
  rig.Release(1);
  rig.Run(milliseconds(20));
  rig.Hold(1);
  rig.Run(milliseconds(20));
  EXPECT_EQ(rig.forward(), 1.0);
}

TEST(LinkSupervision, DeflectedStickIsNotNeutral) {
  SupervisionRig rig;
  rig.panel.axis[0].value = 0.5;
  rig.BringUp();
  EXPECT_EQ(rig.outcome().reason, InhibitReason::kNeutralNeeded);
  rig.panel.axis[0].value = 0;
  rig.Run(milliseconds(40));
  EXPECT_TRUE(rig.is_permitted());
}

TEST(LinkSupervision, StickThatComesBackDeflectedDoesNotStartAnything) {
  SupervisionRig rig;
  rig.BringUp();
  rig.sends_axes = false;
  rig.Run(milliseconds(200));
  EXPECT_TRUE(rig.is_permitted()) << "silent sticks at rest do no harm";
  rig.panel.axis[0].value = 1;
  rig.sends_axes = true;
  rig.Run(milliseconds(40));
  EXPECT_TRUE(rig.IsAtRest());
  EXPECT_EQ(rig.outcome().reason, InhibitReason::kNeutralNeeded);
}

TEST(LinkSupervision, SticksThatComeAndGoAtRestDoNotStopAButton) {
  SupervisionRig rig;
  rig.sends_axes = false;
  rig.DriveForward();
  rig.sends_axes = true;
  rig.Run(milliseconds(40));
  EXPECT_EQ(rig.forward(), 1.0);
  rig.sends_axes = false;
  rig.Run(milliseconds(1000));
  EXPECT_EQ(rig.forward(), 1.0);
}

TEST(LinkSupervision, StickThatFallsSilentWhileDeflectedStops) {
  SupervisionRig rig;
  rig.BringUp();
  rig.panel.axis[0].value = 1;
  rig.Run(milliseconds(40));  // last axes frame at 340 ms
  ASSERT_GT(rig.forward(), 0);
  rig.sends_axes = false;
  rig.Run(milliseconds(100));
  EXPECT_TRUE(rig.is_permitted());
  rig.Run(milliseconds(1));
  EXPECT_EQ(rig.outcome().refusal, Refusal::kAxesLost);
}

// Opposite buttons.

TEST(LinkSupervision, OppositeButtonsAreBothOffAndOthersGoOn) {
  SupervisionRig rig;
  rig.DriveForward();
  rig.Hold(2);  // reverse, against forward
  rig.Hold(9);  // big arm up
  rig.Run(milliseconds(20));
  EXPECT_TRUE(rig.is_permitted());
  EXPECT_EQ(rig.outcome().rate[0], 0);
  EXPECT_EQ(rig.outcome().rate[1], 0);
  EXPECT_EQ(rig.outcome().rate[8], 1);
  EXPECT_EQ(rig.outcome().reason, InhibitReason::kConflict);
  EXPECT_EQ(rig.outcome().inhibit_mask, 0b11U);
}

TEST(LinkSupervision, EveryPairOfOppositesConflicts) {
  for (int motion = 1; motion < dbc::kMotionCount; motion += 2) {
    SupervisionRig rig;
    rig.BringUp();
    rig.Hold(motion);
    rig.Hold(motion + 1);
    rig.Run(milliseconds(20));
    EXPECT_TRUE(rig.IsAtRest());
    EXPECT_EQ(rig.outcome().inhibit_mask, 0b11U << (motion - 1));
  }
}

TEST(LinkSupervision, NeighboursOfDifferentPairsDoNotConflict) {
  SupervisionRig rig;
  rig.BringUp();
  rig.Hold(2);  // reverse
  rig.Hold(3);  // turn left
  rig.Run(milliseconds(20));
  EXPECT_EQ(rig.outcome().rate[1], 1);
  EXPECT_EQ(rig.outcome().rate[2], 1);
  EXPECT_EQ(rig.outcome().reason, InhibitReason::kNone);
}

TEST(LinkSupervision, StickAgainstButtonConflicts) {
  SupervisionRig rig;
  rig.BringUp();
  rig.Hold(2);                  // reverse by button
  rig.panel.axis[0].value = 1;  // forward by stick
  rig.Run(milliseconds(20));
  EXPECT_TRUE(rig.IsAtRest());
  EXPECT_EQ(rig.outcome().reason, InhibitReason::kConflict);
}

// Simulator and bus.

TEST(LinkSupervision, SimulatorMayBeSilentFor500MillisecondsAndNotMore) {
  SupervisionRig rig;
  rig.DriveForward();  // at 340 ms, simulator just heard
  rig.simulator_runs = false;
  rig.Run(milliseconds(500));
  EXPECT_TRUE(rig.is_permitted());
  rig.Run(milliseconds(1));
  EXPECT_TRUE(rig.IsAtRest());
  EXPECT_EQ(rig.outcome().state, SystemState::kFault);
  EXPECT_EQ(rig.outcome().refusal, Refusal::kSimulatorSilent);
}

TEST(LinkSupervision, SimulatorThatReturnsNeedsNeutralOnly) {
  SupervisionRig rig;
  rig.DriveForward();
  rig.simulator_runs = false;
  rig.Run(milliseconds(600));
  rig.simulator_runs = true;
  rig.Run(milliseconds(40));
  EXPECT_EQ(rig.outcome().refusal, Refusal::kNeutralNeeded);
  rig.Release(1);
  rig.Run(milliseconds(40));
  EXPECT_TRUE(rig.is_permitted());
}

TEST(LinkSupervision, NeverMovesBeforeASimulatorWasHeard) {
  SupervisionRig rig;
  rig.simulator_runs = false;
  rig.DriveForward();
  EXPECT_FALSE(rig.is_permitted());
  EXPECT_NE(rig.outcome().state, SystemState::kFault) << "it may still be starting";
  rig.Run(milliseconds(500));
  EXPECT_EQ(rig.outcome().state, SystemState::kFault);
}

TEST(LinkSupervision, BusThatIsDownOrOffRampsToZeroAndSaysWhy) {
  for (const CanBusState state : {CanBusState::kDown, CanBusState::kBusOff}) {
    SupervisionRig rig;
    rig.DriveForward();
    rig.dut.NoteBus(rig.now, CanBusState::kUp, 0);
    rig.dut.NoteBus(rig.now, state, 0);
    EXPECT_FALSE(rig.is_permitted());
    EXPECT_TRUE(rig.outcome().link_alarm);
    EXPECT_EQ(rig.outcome().refusal,
              state == CanBusState::kDown ? Refusal::kBusDown : Refusal::kBusOff);
    rig.Run(milliseconds(200));
    EXPECT_TRUE(rig.IsAtRest());
  }
}

TEST(LinkSupervision, BusThatWentAndCameBackUnseenStopsUntilNeutral) {
  SupervisionRig rig;
  rig.DriveForward();
  rig.dut.NoteBus(rig.now, CanBusState::kUp, 3);
  EXPECT_TRUE(rig.is_permitted()) << "what was before this bridge does not count";
  rig.dut.NoteBus(rig.now, CanBusState::kUp, 4);
  EXPECT_FALSE(rig.is_permitted());
  EXPECT_EQ(rig.outcome().state, SystemState::kSafeStop);
  rig.Release(1);
  rig.Run(milliseconds(40));
  EXPECT_TRUE(rig.is_permitted());
  EXPECT_FALSE(rig.outcome().link_alarm);
}

TEST(LinkSupervision, AnotherRobotStopsForGood) {
  SupervisionRig rig;
  rig.DriveForward();
  rig.dut.NoteForeignRobot(rig.now);
  EXPECT_TRUE(rig.IsAtRest());
  rig.Release(1);
  rig.PressReset();
  rig.PressStart();
  rig.Hold(1);
  rig.Run(milliseconds(1000));
  EXPECT_TRUE(rig.IsAtRest());
  EXPECT_EQ(rig.outcome().state, SystemState::kFault);
  EXPECT_EQ(rig.outcome().refusal, Refusal::kForeignRobot);
}

}  // namespace
}  // namespace eod::bridge
