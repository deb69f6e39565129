// The link itself: strangers on the bus, restarts, counters, noise; same inputs, same bits out.
#include <random>

#include <gtest/gtest.h>

#include "tests/unit/canbridge/bridge_rig.h"

namespace eod::bridge {
namespace {

using dbc::BoxMessage;
using dbc::RobotMessage;
using dbc::SystemState;

TEST(ForeignRobot, SilencesTheBridgeForGood) {
  BridgeRig rig;
  rig.BringUp();
  rig.Hold(1);
  rig.Run(milliseconds(40));
  ASSERT_EQ(rig.forward(), 1.0);
  // A live robot's heartbeat.
  rig.Forget();
  rig.Take({.id = rig.IdOf(RobotMessage::kHeartbeat), .length = 1, .data = {5}});
  EXPECT_EQ(rig.commands.back().motion_rate, MotionRates{});
  EXPECT_EQ(rig.commands.back().system_state, SystemState::kFault);
  ASSERT_FALSE(rig.links.empty());
  EXPECT_TRUE(rig.links.back().foreign_robot);
  EXPECT_NE(rig.links.back().fault, "");
  rig.Release(1);
  rig.Run(milliseconds(100));
  rig.panel.reset = dbc::Button::kPressed;
  rig.Run(milliseconds(1000));
  EXPECT_TRUE(rig.sent.empty()) << "not one frame more";
  EXPECT_FALSE(rig.commands.back().motion_permitted);
  EXPECT_TRUE(rig.links.back().foreign_robot);

  // Only a restart ends it.
  rig.dut.emplace(BridgeConfig{}, rig.database, rig.map);
  rig.Run(milliseconds(100));
  EXPECT_FALSE(rig.sent.empty());
}

TEST(ForeignRobot, AnyRobotIdentifierCounts) {
  for (int i = 0; i < dbc::kRobotMessageCount; ++i) {
    BridgeRig rig;
    rig.Run(milliseconds(10));
    rig.Take({.id = rig.IdOf(static_cast<RobotMessage>(i)), .length = 8});
    EXPECT_TRUE(rig.dut->is_silent()) << i;
  }
}

TEST(ForeignRobot, OtherNodesDoNotSilenceTheBridge) {
  BridgeRig rig;
  rig.BringUp();
  const uint32_t robot_id = rig.IdOf(RobotMessage::kStatus);
  rig.Take({.id = 0x123, .length = 8});                       // somebody else's
  rig.Take({.id = robot_id, .extended = true, .length = 8});  // 29 bit: another identifier
  rig.Take({.id = robot_id, .remote = true, .length = 8});    // a request is not a robot
  rig.Take({.id = 0x20000040, .error = true, .length = 8});   // a controller's report
  EXPECT_FALSE(rig.dut->is_silent());
  EXPECT_TRUE(rig.commands.back().motion_permitted);
}

TEST(BridgeRestart, BootsIntoStandbyAndMovesOnlyAfterNeutral) {
  BridgeRig rig;
  rig.BringUp();
  rig.Hold(1);
  rig.Run(milliseconds(40));
  ASSERT_EQ(rig.forward(), 1.0);
  rig.dut.emplace(BridgeConfig{}, rig.database, rig.map);
  rig.Forget();
  rig.Run(milliseconds(1));
  EXPECT_EQ(rig.sent[0].frame.id, rig.IdOf(RobotMessage::kHeartbeat));
  EXPECT_EQ(rig.sent[0].frame.data[0], 0x00) << "boot-up";
  EXPECT_EQ(rig.commands.back().system_state, SystemState::kStandby);
  rig.Run(milliseconds(1000));
  EXPECT_EQ(rig.forward(), 0.0) << "M01 is held since before the restart";
  EXPECT_EQ(rig.commands.back().inhibit_reason, dbc::InhibitReason::kNeutralNeeded);
  rig.Release(1);
  rig.Run(milliseconds(40));
  rig.Hold(1);
  rig.Run(milliseconds(40));
  EXPECT_EQ(rig.forward(), 1.0);
}

TEST(LinkStatus, IsPublishedEvery100MillisecondsAndOnChange) {
  BridgeRig rig;
  rig.BringUp();
  rig.Run(milliseconds(100));
  rig.Forget();
  rig.Run(milliseconds(1000));
  EXPECT_EQ(rig.links.size(), 10U);
  EXPECT_EQ(rig.links.back().fault, "");
  rig.Forget();
  rig.panel.deadman = dbc::Deadman::kReleased;
  rig.SendFromBox(BoxMessage::kSafety);
  ASSERT_EQ(rig.links.size(), 1U) << "at once";
  EXPECT_EQ(rig.links.back().system_state, SystemState::kReady);
  EXPECT_EQ(rig.links.back().fault, "enabling switch is not held");
}

TEST(LinkStatus, CountsWhatWasDropped) {
  BridgeRig rig;
  rig.BringUp();
  rig.Run(milliseconds(5));
  // Wrong CRC.
  CanFrame frame = *rig.box.Encode(BoxMessage::kSafety, rig.panel);
  frame.data[3] ^= 0x10;
  rig.Take(frame);
  // A repeated frame.
  frame = *rig.box.Encode(BoxMessage::kMotion, rig.panel);
  rig.Take(frame);
  rig.Take(frame);
  // Too short.
  frame = *rig.box.Encode(BoxMessage::kAxes, rig.panel);
  frame.length = 7;
  rig.Take(frame);
  // Not in the DBC.
  rig.Take({.id = 0x7E0, .length = 8});
  rig.bus.counters.rx_lost = 11;
  rig.Run(milliseconds(120));
  const LinkStatus& link = rig.links.back();
  EXPECT_EQ(link.rejects.crc, 1);
  EXPECT_EQ(link.rejects.counter, 1);
  EXPECT_EQ(link.rejects.length, 1);
  EXPECT_EQ(link.rejects.unknown_id, 1);
  // The dropped safety and axes frames left a gap of one each.
  EXPECT_EQ(link.lost, 11U + 2U);
}

TEST(LinkStatus, SaysThatTheBusIsDownOrOff) {
  BridgeRig rig;
  rig.BringUp();
  rig.bus.state = CanBusState::kDown;
  rig.Run(milliseconds(1));
  EXPECT_EQ(rig.links.back().fault, "CAN bus is down");
  rig.bus.state = CanBusState::kBusOff;
  rig.Run(milliseconds(1));
  EXPECT_EQ(rig.links.back().fault, "CAN controller is bus-off");
  EXPECT_EQ(rig.alarm_changes, (std::vector<AlarmChange>{{kLinkAlarm, true}}));
}

TEST(BridgeAlarms, AreRaisedAndClearedWithTheirCause) {
  BridgeRig rig;
  rig.BringUp();
  rig.Forget();
  rig.panel.estop_a = false;
  rig.panel.estop_b = true;
  rig.Run(milliseconds(20));
  EXPECT_EQ(rig.alarm_changes, (std::vector<AlarmChange>{{kEstopAlarm, true}}));
  rig.panel.estop_a = true;
  rig.panel.estop_b = false;
  rig.Run(milliseconds(40));
  rig.Forget();
  rig.panel.reset = dbc::Button::kPressed;
  rig.Run(milliseconds(20));
  EXPECT_EQ(rig.alarm_changes, (std::vector<AlarmChange>{{kEstopAlarm, false}}));
  EXPECT_EQ(rig.shown.alarm_code, 0);
}

TEST(WrongSequence, ThreeGoodFramesBringTheMessageBack) {
  BridgeRig rig;
  rig.BringUp();
  rig.Run(milliseconds(20));
  // The counter jumps by 5: four frames are thrown away.
  for (int i = 0; i < 4; ++i) rig.box.Encode(BoxMessage::kMotion, rig.panel);
  rig.Hold(1);
  rig.Forget();
  rig.Run(milliseconds(60));
  EXPECT_EQ(rig.forward(), 0.0) << "dropped: the jump, then two good ones";
  rig.Run(milliseconds(20));
  EXPECT_EQ(rig.forward(), 1.0) << "the third good one counts";
}

// Noise.

CanFrame RandomFrame(std::mt19937& random, const std::vector<uint32_t>& ids) {
  CanFrame frame;
  frame.id = ids[random() % ids.size()];
  if (random() % 16 == 0) frame.id = random() % 0x800;
  frame.extended = random() % 32 == 0;
  frame.remote = random() % 64 == 0;
  frame.length = random() % 4 == 0 ? static_cast<uint8_t>(random() % 9) : uint8_t{8};
  for (std::size_t i = 0; i < frame.length && !frame.remote; ++i) {
    frame.data[i] = static_cast<uint8_t>(random());
  }
  return frame;
}

std::vector<uint32_t> BoxIds(const BridgeRig& rig) {
  std::vector<uint32_t> ids;
  for (const auto& [role, mapped] : rig.map.box_messages) {
    ids.push_back(rig.database.FindMessage(mapped.message)->id);
  }
  return ids;
}

TEST(Noise, HundredThousandRandomFramesNeverMoveTheRobot) {
  BridgeRig rig;
  rig.box_runs = false;
  const std::vector<uint32_t> ids = BoxIds(rig);
  std::mt19937 random(20261122);
  for (int i = 0; i < 100'000; ++i) {
    const CanFrame frame = RandomFrame(random, ids);
    if (rig.box.IsRobotId(frame.id, frame.extended)) continue;  // would only silence it
    rig.Take(frame);
    rig.now += std::chrono::microseconds(200);
    if (i % 5 == 0) rig.Run(milliseconds(1));
    if (i % 1000 == 0) rig.sent.clear();
  }
  for (const BoxCommand& command : rig.commands) {
    ASSERT_FALSE(command.motion_permitted);
    ASSERT_EQ(command.motion_rate, MotionRates{});
  }
}

TEST(Noise, RandomFramesBesideADeadBoxDoNotKeepItMoving) {
  BridgeRig rig;
  const std::vector<uint32_t> ids = BoxIds(rig);
  std::mt19937 random(1);
  for (int round = 0; round < 50; ++round) {
    BridgeRig each;
    each.BringUp();
    each.Hold(1);
    each.Run(milliseconds(40));
    ASSERT_EQ(each.forward(), 1.0);
    each.box_runs = false;
    for (int i = 0; i < 301; ++i) {
      const CanFrame frame = RandomFrame(random, ids);
      if (!each.box.IsRobotId(frame.id, frame.extended)) each.Take(frame);
      each.Run(milliseconds(1));
    }
    EXPECT_EQ(each.commands.back().motion_rate, MotionRates{}) << round;
  }
}

TEST(Noise, EveryFlippedBitOfAProtectedFrameIsCaught) {
  for (const BoxMessage role : {BoxMessage::kSafety, BoxMessage::kMotion, BoxMessage::kAxes}) {
    BridgeRig rig;
    rig.BringUp();
    const CanFrame good = *rig.box.Encode(role, rig.panel);
    for (std::size_t bit = 0; bit < 64; ++bit) {
      CanFrame bad = good;
      bad.data[bit / 8] ^= static_cast<uint8_t>(1U << bit % 8);
      dbc::BoxCodec receiver(rig.database, rig.map);
      dbc::PanelState panel;
      EXPECT_EQ(receiver.Decode(bad, panel).verdict, dbc::FrameVerdict::kWrongCrc) << bit;
    }
  }
}

TEST(Determinism, SameInputsGiveTheSameFramesAndCommands) {
  const auto run = [] {
    BridgeRig rig;
    rig.panel_frames = true;
    rig.BringUp();
    std::mt19937 random(7);
    for (int i = 0; i < 300; ++i) {
      rig.panel.motion[random() % dbc::kMotionCount] = random() % 2 == 0;
      rig.panel.axis[random() % dbc::kAxisCount].value =
          static_cast<int>(random() % 201) / 100.0 - 1;
      rig.robot.inhibit_mask = random() & 0x3FFFFF;
      if (i % 7 == 0) rig.Alarm({{0x10, static_cast<uint32_t>(random() % 16)}});
      rig.Run(milliseconds(random() % 30));
    }
    return rig;
  };
  const BridgeRig a = run();
  const BridgeRig b = run();
  EXPECT_EQ(a.commands, b.commands);
  ASSERT_EQ(a.sent.size(), b.sent.size());
  for (std::size_t i = 0; i < a.sent.size(); ++i) {
    EXPECT_EQ(a.sent[i].time, b.sent[i].time);
    EXPECT_TRUE(SameOnWire(a.sent[i].frame, b.sent[i].frame));
  }
}

}  // namespace
}  // namespace eod::bridge
