// The node: what goes over LCM and CAN, in process and in virtual time.
#include "canbridge/bridge_node.h"

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "canbridge/describe.h"
#include "dbc/box_codec.h"
#include "platform/inproc_can_bus.h"

namespace eod::bridge {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

const BridgeNodeConfig kConfig{.dbc_file = EOD_DATA_DIR "/dbc/control_box.dbc",
                               .map_file = EOD_DATA_DIR "/dbc/control_box.map.toml",
                               .channel_prefix = "LAB1_",
                               .bridge = {}};

/// What came over LCM.
struct Inbox {
  void OnCommand(const lcm::ReceiveBuffer*, const std::string&, const box_command_t* message) {
    commands.push_back(*message);
  }
  void OnLink(const lcm::ReceiveBuffer*, const std::string&, const link_status_t* message) {
    links.push_back(*message);
  }
  void OnAlarm(const lcm::ReceiveBuffer*, const std::string&, const alarm_t* message) {
    alarms.push_back(*message);
  }

  std::vector<box_command_t> commands;
  std::vector<link_status_t> links;
  std::vector<alarm_t> alarms;
};

class BridgeNodeTest : public testing::Test {
 protected:
  BridgeNodeTest() {
    lcm.subscribe("LAB1_EOD_BOX_COMMAND", &Inbox::OnCommand, &inbox);
    lcm.subscribe("LAB1_EOD_LINK_STATUS", &Inbox::OnLink, &inbox);
    lcm.subscribe("LAB1_EOD_ALARM", &Inbox::OnAlarm, &inbox);
    panel.key = dbc::KeySwitch::kOperate;
    panel.nmt = dbc::NmtState::kOperational;
  }

  // memq delivers one message a call.
  void Deliver() {
    while (lcm.handleTimeout(0) > 0) {
    }
  }

  void Run(int milliseconds_count) {
    for (int i = 0; i < milliseconds_count; ++i) {
      clock.Advance(milliseconds(1));
      ++time_ms;
      if (time_ms % 4 == 0) lcm.publish("LAB1_EOD_ROBOT_STATE", &state);
      if (time_ms % 200 == 0) SendFromBox(dbc::BoxMessage::kHeartbeat);
      if (time_ms % 20 == 0) {
        SendFromBox(dbc::BoxMessage::kSafety);
        SendFromBox(dbc::BoxMessage::kMotion);
      }
      Deliver();
      node->OnCan();
      node->OnTick(clock.Now());
      Deliver();
    }
  }

  void SendFromBox(dbc::BoxMessage role) { box_bus->Send(*box.Encode(role, panel)); }

  void ReceiveAtBox() {
    while (const std::optional<CanFrame> frame = box_bus->Receive()) {
      const auto received = box.Decode(*frame, shown);
      if (received.role) received_roles.push_back(*received.role);
    }
  }

  ManualClock clock;
  InprocCanHub hub{"bench"};
  std::unique_ptr<CanBus> box_bus = hub.Connect(clock);
  std::unique_ptr<CanBus> bridge_bus = hub.Connect(clock);
  lcm::LCM lcm{"memq://"};
  dbc::Database database = dbc::LoadDatabase(kConfig.dbc_file);
  dbc::ControlMap map = dbc::LoadControlMap(kConfig.map_file);
  dbc::BoxCodec box{database, map};
  std::unique_ptr<BridgeNode> node = std::make_unique<BridgeNode>(kConfig, *bridge_bus, lcm, clock);
  dbc::PanelState panel;
  robot_state_t state{};
  dbc::RobotFeedback shown;
  std::vector<dbc::RobotMessage> received_roles;
  Inbox inbox;
  std::vector<box_command_t>& commands = inbox.commands;
  std::vector<link_status_t>& links = inbox.links;
  std::vector<alarm_t>& alarms = inbox.alarms;
  int time_ms = 0;
};

TEST_F(BridgeNodeTest, ButtonOnTheBusBecomesACommandOnThePrefixedChannel) {
  Run(240);
  panel.deadman = dbc::Deadman::kEnabled;
  Run(60);
  commands.clear();
  panel.motion[0] = true;
  SendFromBox(dbc::BoxMessage::kMotion);
  node->OnCan();
  Deliver();
  ASSERT_EQ(commands.size(), 1U) << "before any tick";
  EXPECT_EQ(commands[0].motion_rate[0], 1.0);
  EXPECT_TRUE(commands[0].motion_permitted);
  EXPECT_EQ(commands[0].system_state, box_command_t::STATE_OPERATE);
  EXPECT_EQ(commands[0].utime, 300'000);
  const int32_t sequence = commands[0].sequence;
  Run(20);
  EXPECT_EQ(commands.back().sequence, sequence + 1);
}

TEST_F(BridgeNodeTest, AlarmOfTheSimulatorIsOnTheBusBeforeAnyTick) {
  Run(120);
  ReceiveAtBox();
  received_roles.clear();
  alarm_t alarm{};
  alarm.source = alarm_t::SOURCE_SIM;
  alarm.num_active = 1;
  alarm.active_code = {0x10};
  alarm.active_parts = {0b11};
  lcm.publish("LAB1_EOD_ALARM", &alarm);
  Deliver();
  ReceiveAtBox();
  EXPECT_EQ(received_roles, std::vector{dbc::RobotMessage::kAlarm});
  EXPECT_EQ(shown.alarm_code, 0x10);
  EXPECT_EQ(shown.hit_parts, 0b11U);
}

TEST_F(BridgeNodeTest, ItsOwnAlarmsComeBackWithoutEffectAndAreRepeated) {
  Run(240);
  panel.estop_a = false;
  panel.estop_b = true;
  alarms.clear();
  Run(20);
  ASSERT_FALSE(alarms.empty());
  EXPECT_EQ(alarms[0].source, alarm_t::SOURCE_BRIDGE);
  EXPECT_EQ(alarms[0].code, 0x80);
  EXPECT_TRUE(alarms[0].raised);
  EXPECT_EQ(alarms[0].active_code, std::vector<int16_t>{0x80});
  EXPECT_FALSE(alarms[0].is_repeat);
  alarms.clear();
  Run(1000);
  EXPECT_EQ(alarms.size(), 10U);
  EXPECT_TRUE(alarms.back().is_repeat);
  EXPECT_EQ(alarms.back().active_code, std::vector<int16_t>{0x80});
  ReceiveAtBox();
  EXPECT_EQ(shown.alarm_code, 0x80);
}

TEST_F(BridgeNodeTest, LinkStatusNamesTheBusAndItsCounters) {
  Run(300);
  ASSERT_FALSE(links.empty());
  const link_status_t& link = links.back();
  EXPECT_EQ(link.bus, bridge_bus->url());
  // By 200 ms the box had sent a heartbeat, ten safety and ten motion frames.
  EXPECT_GE(link.rx, 21);
  EXPECT_LE(link.rx, static_cast<int64_t>(bridge_bus->counters().rx));
  EXPECT_GT(link.tx, 0);
  EXPECT_EQ(link.fault, "enabling switch is not held");
  EXPECT_THAT(link.box_frame_age_ms, testing::AllOf(testing::Ge(0), testing::Le(20)));
}

TEST_F(BridgeNodeTest, RobotStateReachesTheBox) {
  state.module = 1;
  state.heading_deg = 90;
  state.joint[2] = 120;
  state.inhibit_mask = 0b1;
  state.inhibit_reason = box_command_t::REASON_COLLISION;
  Run(120);
  ReceiveAtBox();
  EXPECT_EQ(shown.module, dbc::Module::kFlat);
  EXPECT_EQ(shown.heading_deg, 90);
  EXPECT_NEAR(shown.joint[2], 120, 0.005);
  EXPECT_EQ(shown.inhibit_mask, 0b1U);
  EXPECT_EQ(shown.inhibit_reason, dbc::InhibitReason::kCollision);
}

TEST_F(BridgeNodeTest, FirePanelReachesTheSimulatorAndTheFireStateTheBox) {
  Run(240);
  panel.deadman = dbc::Deadman::kEnabled;
  Run(60);
  panel.arm_key = dbc::FireContact::kOn;
  panel.fire_left = dbc::FireContact::kOn;
  panel.circuit = 3;
  panel.nonce_echo = 200;
  SendFromBox(dbc::BoxMessage::kFire);
  node->OnCan();
  Deliver();
  // Contacts as box_command_t has them: 1 safe or released, 2 armed or pressed.
  EXPECT_EQ(commands.back().arm_key, 2);
  EXPECT_EQ(commands.back().fire_left, 2);
  EXPECT_EQ(commands.back().fire_right, 1);
  EXPECT_EQ(commands.back().circuit, 3);
  EXPECT_EQ(commands.back().nonce_echo, 200);
  state.fire_state = 2;
  state.fire_nonce = 201;
  state.circuit_continuity = 0b110;
  Run(8);
  ReceiveAtBox();
  EXPECT_EQ(shown.fire_state, 2);
  EXPECT_EQ(shown.nonce, 201);
  EXPECT_EQ(shown.circuit_continuity, 0b110U);
  Run(101);
  EXPECT_EQ(commands.back().arm_key, 1) << "no fire frame for 109 ms";
  EXPECT_EQ(commands.back().fire_left, 1);
  EXPECT_EQ(commands.back().circuit, 0);
}

TEST_F(BridgeNodeTest, NodeThatIsGoneLeavesNothingBehind) {
  node.reset();
  lcm.publish("LAB1_EOD_ROBOT_STATE", &state);
  Deliver();
  node = std::make_unique<BridgeNode>(kConfig, *bridge_bus, lcm, clock);
  Run(10);
  EXPECT_FALSE(commands.empty());
}

TEST_F(BridgeNodeTest, AnotherRobotIsTold) {
  Run(100);
  box_bus->Send({.id = 0x1A0, .length = 8});
  Run(2);
  EXPECT_TRUE(links.back().foreign_robot);
  ReceiveAtBox();
  received_roles.clear();
  Run(500);
  ReceiveAtBox();
  EXPECT_TRUE(received_roles.empty());
}

TEST(Describe, NamesEveryMessageWithIdCycleAndRole) {
  const std::string text = DescribeBridge(kConfig, "udp:239.74.163.2:43113");
  EXPECT_THAT(text, HasSubstr("bus: udp:239.74.163.2:43113"));
  EXPECT_THAT(text, testing::ContainsRegex("0x190 +BOX_SAFETY +20 ms +from box +safety +E2E"));
  EXPECT_THAT(text, testing::ContainsRegex("0x0A0 +ROB_EMCY +event +to box +emergency"));
  EXPECT_THAT(text, HasSubstr("LAB1_EOD_BOX_COMMAND"));
}

TEST(BridgeNodeStart, RefusesFilesThatAreNotThere) {
  BridgeNodeConfig config = kConfig;
  config.map_file = "nowhere.map.toml";
  ManualClock clock;
  const auto bus = OpenInprocCanBus("start", clock);
  lcm::LCM lcm("memq://");
  try {
    const BridgeNode dut(config, *bus, lcm, clock);
    FAIL() << "loaded";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("nowhere.map.toml"));
  }
}

}  // namespace
}  // namespace eod::bridge
