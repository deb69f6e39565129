// Silence and noise on the link: what stops, what latches, what clears itself.
#include <gtest/gtest.h>

#include "tests/unit/canbridge/supervision_rig.h"

namespace eod::bridge {
namespace {

using dbc::BoxMessage;
using dbc::FrameVerdict;
using dbc::InhibitReason;
using dbc::SystemState;

// Loss of frames. DriveForward ends at 340 ms, with frames sent at 340 ms.

void GoSilent(SupervisionRig& rig) { rig.sends_safety = rig.sends_motion = rig.sends_axes = false; }

void Return(SupervisionRig& rig) { rig.sends_safety = rig.sends_motion = rig.sends_axes = true; }

TEST(LinkLoss, FramesMayBe100MillisecondsOldAndNotMore) {
  SupervisionRig rig;
  rig.DriveForward();
  GoSilent(rig);
  rig.Run(milliseconds(99));
  EXPECT_TRUE(rig.is_permitted());
  rig.Run(milliseconds(1));
  EXPECT_TRUE(rig.is_permitted());
  EXPECT_EQ(rig.forward(), 1.0);
  rig.Run(milliseconds(1));
  EXPECT_FALSE(rig.is_permitted());
  EXPECT_EQ(rig.outcome().state, SystemState::kSafeStop);
  EXPECT_EQ(rig.outcome().reason, InhibitReason::kLinkLoss);
  EXPECT_TRUE(rig.outcome().link_alarm);
}

TEST(LinkLoss, EitherMessageAloneStops) {
  for (bool SupervisionRig::*frames :
       {&SupervisionRig::sends_safety, &SupervisionRig::sends_motion}) {
    SupervisionRig rig;
    rig.DriveForward();
    rig.*frames = false;
    rig.Run(milliseconds(100));
    EXPECT_TRUE(rig.is_permitted());
    rig.Run(milliseconds(1));
    EXPECT_EQ(rig.outcome().state, SystemState::kSafeStop);
  }
}

TEST(LinkLoss, RampsToZeroWithin200Milliseconds) {
  SupervisionRig rig;
  rig.DriveForward();
  GoSilent(rig);
  double before = 1.0;
  // The ramp runs from age 100 ms to age 300 ms: at age 200 ms half is left.
  for (int age = 101; age <= 300; ++age) {
    rig.Run(milliseconds(age == 101 ? 101 : 1));
    EXPECT_NEAR(rig.forward(), (300 - age) / 200.0, 1e-9) << age;
    EXPECT_LT(rig.forward(), before);
    before = rig.forward();
  }
  EXPECT_TRUE(rig.IsAtRest());
}

TEST(LinkLoss, SafeStopClearsItselfAfterNeutral) {
  SupervisionRig rig;
  rig.DriveForward();
  GoSilent(rig);
  rig.Run(milliseconds(150));
  Return(rig);
  rig.Run(milliseconds(250));
  EXPECT_EQ(rig.outcome().state, SystemState::kSafeStop) << "M01 is still held";
  EXPECT_TRUE(rig.IsAtRest());
  rig.Release(1);
  rig.Run(milliseconds(20));
  EXPECT_EQ(rig.outcome().state, SystemState::kOperate);
  EXPECT_FALSE(rig.outcome().link_alarm);
  rig.Hold(1);
  rig.Run(milliseconds(20));
  EXPECT_EQ(rig.forward(), 1.0);
}

TEST(LinkLoss, RampGoesOnWhenFramesComeBackWithTheButtonHeld) {
  SupervisionRig rig;
  rig.DriveForward();
  GoSilent(rig);
  rig.Run(milliseconds(140));
  Return(rig);
  rig.Run(milliseconds(60));  // age of the gap 200 ms: half
  EXPECT_NEAR(rig.forward(), 0.5, 1e-9);
}

TEST(LinkLoss, StopSignalThatComesDuringTheRampStopsAtOnce) {
  SupervisionRig rig;
  rig.DriveForward();
  GoSilent(rig);
  rig.Run(milliseconds(140));
  ASSERT_GT(rig.forward(), 0);
  rig.panel.deadman = dbc::Deadman::kReleased;
  rig.Send(BoxMessage::kSafety);
  EXPECT_TRUE(rig.IsAtRest());
}

TEST(LinkLoss, LatchesAfter500MillisecondsAndNotBefore) {
  for (const int silence_ms : {499, 500, 501}) {
    SupervisionRig rig;
    rig.DriveForward();
    rig.Release(1);
    GoSilent(rig);
    rig.Run(milliseconds(silence_ms));
    rig.Send(BoxMessage::kSafety);
    rig.Send(BoxMessage::kMotion);
    Return(rig);
    rig.Run(milliseconds(60));
    EXPECT_EQ(rig.is_permitted(), silence_ms <= 500) << silence_ms;
    EXPECT_EQ(rig.outcome().state, silence_ms <= 500 ? SystemState::kOperate : SystemState::kFault);
  }
}

TEST(LinkLoss, GapIsSeenEvenIfNoTickFellIntoIt) {
  SupervisionRig rig;
  rig.DriveForward();
  rig.now += milliseconds(501);  // the process was held up
  rig.dut.NoteSimulator(rig.now);
  rig.Send(BoxMessage::kSafety);
  rig.Send(BoxMessage::kMotion);
  EXPECT_EQ(rig.outcome().state, SystemState::kFault);
  EXPECT_TRUE(rig.IsAtRest());
}

TEST(LinkLoss, LatchedLossNeedsResetAndStart) {
  SupervisionRig rig;
  rig.DriveForward();
  rig.Release(1);
  GoSilent(rig);
  rig.Run(milliseconds(600));
  Return(rig);
  rig.Run(milliseconds(200));
  EXPECT_EQ(rig.outcome().refusal, Refusal::kLinkLatched);
  rig.PressReset();
  EXPECT_EQ(rig.outcome().refusal, Refusal::kStartNeeded);
  rig.PressStart();
  EXPECT_TRUE(rig.is_permitted());
}

// CRC and counter errors.

TEST(CrcRule, ThreeInARowAreALinkFault) {
  SupervisionRig rig;
  rig.DriveForward();
  rig.dut.Reject(rig.now, BoxMessage::kSafety, FrameVerdict::kWrongCrc);
  rig.dut.Reject(rig.now, BoxMessage::kSafety, FrameVerdict::kWrongCrc);
  EXPECT_TRUE(rig.is_permitted());
  rig.dut.Reject(rig.now, BoxMessage::kSafety, FrameVerdict::kWrongCrc);
  EXPECT_TRUE(rig.IsAtRest());
  EXPECT_EQ(rig.outcome().refusal, Refusal::kCrcFault);
  EXPECT_EQ(rig.outcome().state, SystemState::kFault);
  EXPECT_TRUE(rig.outcome().link_alarm);
}

TEST(CrcRule, GoodFrameOfThatMessageBreaksTheRow) {
  SupervisionRig rig;
  rig.DriveForward();
  for (int i = 0; i < 2; ++i) {
    rig.dut.Reject(rig.now, BoxMessage::kSafety, FrameVerdict::kWrongCrc);
    rig.dut.Reject(rig.now, BoxMessage::kSafety, FrameVerdict::kWrongCrc);
    rig.Send(BoxMessage::kSafety);
  }
  EXPECT_TRUE(rig.is_permitted()) << "four among six, no three in a row";
  rig.dut.Reject(rig.now, BoxMessage::kSafety, FrameVerdict::kWrongCrc);
  EXPECT_EQ(rig.outcome().refusal, Refusal::kCrcFault) << "the fifth";
}

// Wrong frames apart by `period` frames of the message: five of them span 4 * period + 1 frames.
bool FaultsWithErrorEvery(int period) {
  SupervisionRig rig;
  rig.DriveForward();
  for (int i = 0; i < 200; ++i) {
    if (i % period == 0) {
      rig.dut.Reject(rig.now, BoxMessage::kMotion, FrameVerdict::kWrongCrc);
    } else {
      rig.Send(BoxMessage::kMotion);
    }
  }
  return rig.outcome().refusal == Refusal::kCrcFault;
}

TEST(CrcRule, FiveIn50AreALinkFaultAndFiveIn53AreNot) {
  EXPECT_TRUE(FaultsWithErrorEvery(12));   // 4 * 12 + 1 = 49 frames
  EXPECT_FALSE(FaultsWithErrorEvery(13));  // 4 * 13 + 1 = 53 frames
}

TEST(CrcRule, CounterErrorsDoNotCount) {
  SupervisionRig rig;
  rig.DriveForward();
  for (int i = 0; i < 20; ++i) {
    rig.dut.Reject(rig.now, BoxMessage::kSafety, FrameVerdict::kRepeated);
    rig.dut.Reject(rig.now, BoxMessage::kSafety, FrameVerdict::kWrongSequence);
  }
  EXPECT_TRUE(rig.is_permitted()) << "they only let the last good frame grow old";
}

TEST(CrcRule, FaultEndsWithResetAndStart) {
  SupervisionRig rig;
  rig.BringUp();
  for (int i = 0; i < 3; ++i) {
    rig.dut.Reject(rig.now, BoxMessage::kMotion, FrameVerdict::kWrongCrc);
  }
  rig.PressReset();
  rig.PressStart();
  rig.Run(milliseconds(20));
  EXPECT_TRUE(rig.is_permitted());
}

}  // namespace
}  // namespace eod::bridge
