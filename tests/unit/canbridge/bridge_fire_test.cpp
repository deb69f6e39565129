// The fire panel: from the box into the command, and into nothing else; its state back to the box.
#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/canbridge/bridge_rig.h"

namespace eod::bridge {
namespace {

using dbc::BoxMessage;
using dbc::FireContact;
using dbc::Lamp;
using dbc::LampPattern;
using dbc::RobotMessage;

constexpr FirePanel kSafe{};
constexpr FirePanel kFiring{.arm_key = FireContact::kOn,
                            .fire_left = FireContact::kOn,
                            .fire_right = FireContact::kOn,
                            .circuit = 2,
                            .nonce_echo = 0xA5};

/// A robot ready to move, and both fire buttons pressed.
class BridgeFire : public testing::Test {
 protected:
  BridgeFire() {
    rig.fire_frames = true;
    rig.BringUp();
    rig.panel.arm_key = rig.panel.fire_left = rig.panel.fire_right = FireContact::kOn;
    rig.panel.circuit = 2;
    rig.panel.nonce_echo = 0xA5;
    rig.Run(milliseconds(20));
  }

  const FirePanel& fire() const { return rig.commands.back().fire; }
  void SendWrongFireFrame(std::size_t byte) {
    CanFrame frame = *rig.box.Encode(BoxMessage::kFire, rig.panel);
    frame.data[byte] ^= 0x10;
    rig.Take(frame);
  }

  BridgeRig rig;
};

TEST_F(BridgeFire, PanelPassesWhileMotionIsPermitted) {
  EXPECT_TRUE(rig.commands.back().motion_permitted);
  EXPECT_EQ(fire(), kFiring);
  rig.panel.fire_left = FireContact::kFault;
  rig.Run(milliseconds(20));
  EXPECT_EQ(fire().fire_left, FireContact::kFault) << "the simulator must see a broken contact";
}

TEST_F(BridgeFire, PressedButtonIsTranslatedInTheCallThatTookTheFrame) {
  rig.panel.fire_right = FireContact::kOff;
  rig.Run(milliseconds(20));
  rig.Forget();
  rig.panel.fire_right = FireContact::kOn;
  rig.SendFromBox(BoxMessage::kFire);
  ASSERT_EQ(rig.commands.size(), 1U);
  EXPECT_EQ(fire(), kFiring);
}

TEST_F(BridgeFire, FramesOlderThan100MillisecondsMakeItSafe) {
  rig.fire_frames = false;  // the last one came just now, at 320 ms
  rig.Run(milliseconds(100));
  EXPECT_EQ(fire(), kFiring) << "exactly 100 ms";
  rig.Run(milliseconds(1));
  EXPECT_EQ(fire(), kSafe);
  EXPECT_TRUE(rig.commands.back().motion_permitted) << "the other messages still come";
}

TEST_F(BridgeFire, OneFrameWithAWrongCrcMakesItSafeUntilTheNextGoodOne) {
  SendWrongFireFrame(0);
  EXPECT_EQ(fire(), kSafe);
  rig.Run(milliseconds(19));
  EXPECT_EQ(fire(), kSafe);
  rig.Run(milliseconds(1));
  EXPECT_EQ(fire(), kFiring);
}

TEST_F(BridgeFire, RepeatedAndShortFramesMakeItSafe) {
  const CanFrame frame = *rig.box.Encode(BoxMessage::kFire, rig.panel);
  rig.Take(frame);
  EXPECT_EQ(fire(), kFiring);
  rig.Take(frame);
  EXPECT_EQ(fire(), kSafe) << "counter did not advance";
  rig.SendFromBox(BoxMessage::kFire);
  EXPECT_EQ(fire(), kFiring);
  CanFrame cut = *rig.box.Encode(BoxMessage::kFire, rig.panel);
  cut.length = 3;
  rig.Take(cut);
  EXPECT_EQ(fire(), kSafe);
}

TEST_F(BridgeFire, WhateverStopsMotionMakesItSafe) {
  const auto after = [this](auto change) {
    BridgeRig copy_of_controls;
    copy_of_controls.fire_frames = true;
    copy_of_controls.BringUp();
    copy_of_controls.panel = rig.panel;
    copy_of_controls.Run(milliseconds(20));
    EXPECT_EQ(copy_of_controls.commands.back().fire, kFiring);
    change(copy_of_controls);
    copy_of_controls.Run(milliseconds(600));
    return copy_of_controls.commands.back().fire;
  };
  EXPECT_EQ(after([](BridgeRig& r) { r.panel.deadman = dbc::Deadman::kReleased; }), kSafe);
  EXPECT_EQ(after([](BridgeRig& r) { r.panel.key = dbc::KeySwitch::kStandby; }), kSafe);
  EXPECT_EQ(after([](BridgeRig& r) { r.panel.estop_a = false, r.panel.estop_b = true; }), kSafe);
  EXPECT_EQ(after([](BridgeRig& r) { r.panel.box_fault = 1; }), kSafe);
  EXPECT_EQ(after([](BridgeRig& r) { r.box_runs = false; }), kSafe);
  EXPECT_EQ(after([](BridgeRig& r) { r.simulator_runs = false; }), kSafe);
  EXPECT_EQ(after([](BridgeRig& r) { r.bus.state = CanBusState::kBusOff; }), kSafe);
}

TEST_F(BridgeFire, EmergencyStopMakesItSafeInTheCallThatTookTheFrame) {
  rig.panel.estop_a = false;
  rig.panel.estop_b = true;
  rig.Forget();
  rig.SendFromBox(BoxMessage::kSafety);
  ASSERT_EQ(rig.commands.size(), 1U);
  EXPECT_EQ(fire(), kSafe);
}

TEST(BridgeFireBus, NoFrameCarriesAFireCommand) {
  // Two runs that differ in the fire buttons alone, while the robot reports the same.
  const auto run = [](bool fires) {
    BridgeRig rig;
    rig.fire_frames = rig.panel_frames = true;
    rig.BringUp();
    rig.Forget();
    rig.panel.arm_key = FireContact::kOn;
    rig.panel.circuit = 1;
    rig.robot.fire_state = 1;
    rig.Run(milliseconds(1200));
    if (fires) rig.panel.fire_left = rig.panel.fire_right = FireContact::kOn;
    rig.robot.fire_state = 2;
    rig.Run(milliseconds(400));
    rig.robot.fire_state = 3;
    rig.Run(milliseconds(1400));
    return rig;
  };
  const BridgeRig fired = run(true);
  const BridgeRig idle = run(false);
  EXPECT_NE(fired.commands, idle.commands) << "the simulator hears of it";
  std::set<uint32_t> robot_ids;
  for (const dbc::Message& message : fired.database.messages) {
    if (message.name.starts_with("ROB_")) robot_ids.insert(message.id);
  }
  ASSERT_EQ(fired.sent.size(), idle.sent.size());
  for (std::size_t i = 0; i < fired.sent.size(); ++i) {
    EXPECT_TRUE(SameOnWire(fired.sent[i].frame, idle.sent[i].frame));
    EXPECT_TRUE(robot_ids.contains(fired.sent[i].frame.id)) << fired.sent[i].frame.id;
  }
}

TEST_F(BridgeFire, StateNonceAndContinuityAreShownAtOnceAndThenEvery50Milliseconds) {
  rig.Run(milliseconds(5));
  rig.Forget();
  RobotReport report = rig.robot;
  report.fire_state = 2;
  report.fire_nonce = 0xA5;
  report.circuit_continuity = 0b101;
  rig.Report(report);
  ASSERT_EQ(rig.SentAs(RobotMessage::kFire).size(), 1U) << "in the call that took the report";
  EXPECT_EQ(rig.shown.fire_state, 2);
  EXPECT_EQ(rig.shown.nonce, 0xA5);
  EXPECT_EQ(rig.shown.circuit_continuity, 0b101U);
  rig.Forget();
  rig.Run(milliseconds(500));
  EXPECT_EQ(rig.SentAs(RobotMessage::kFire).size(), 10U);
}

TEST_F(BridgeFire, TwoChangesOfTheStateAreTenMillisecondsApart) {
  rig.Run(milliseconds(20));
  rig.Forget();
  for (int nonce = 1; nonce <= 100; ++nonce) {
    rig.robot.fire_nonce = nonce;
    rig.Report(rig.robot);
    rig.Run(milliseconds(1));
  }
  EXPECT_LE(rig.SentAs(RobotMessage::kFire).size(), 13U)
      << "at 0, 10 .. 100 ms, and 2 of the cycle";
  rig.Run(milliseconds(10));
  EXPECT_EQ(rig.shown.nonce, 100);
}

TEST_F(BridgeFire, LampsFollowKeyAndState) {
  const auto lamps_at = [this](int fire_state) {
    rig.robot.fire_state = fire_state;
    rig.Run(milliseconds(20));
    return std::pair(rig.lamp(Lamp::kArmed), rig.lamp(Lamp::kFired));
  };
  EXPECT_EQ(lamps_at(1), std::pair(LampPattern::kOn, LampPattern::kOff)) << "armed, waiting";
  EXPECT_EQ(lamps_at(2), std::pair(LampPattern::kSlowBlink, LampPattern::kOff)) << "ready";
  EXPECT_EQ(lamps_at(3), std::pair(LampPattern::kOn, LampPattern::kOn)) << "fired";
  EXPECT_EQ(lamps_at(4), std::pair(LampPattern::kFastBlink, LampPattern::kOff)) << "fault";
  EXPECT_EQ(lamps_at(5), std::pair(LampPattern::kOn, LampPattern::kOff)) << "time-out, key on";
  rig.panel.arm_key = FireContact::kOff;
  EXPECT_EQ(lamps_at(0), std::pair(LampPattern::kOff, LampPattern::kOff)) << "safe";
  EXPECT_EQ(lamps_at(3), std::pair(LampPattern::kOff, LampPattern::kOn)) << "fired, key off";
}

TEST_F(BridgeFire, SilentSimulatorShowsNothingArmed) {
  rig.robot.fire_state = 2;
  rig.robot.circuit_continuity = 0b111;
  rig.Run(milliseconds(60));
  EXPECT_EQ(rig.shown.fire_state, 2);
  rig.simulator_runs = false;
  rig.Run(milliseconds(600));
  EXPECT_EQ(rig.shown.fire_state, 0);
  EXPECT_EQ(rig.shown.circuit_continuity, 0U);
}

}  // namespace
}  // namespace eod::bridge
