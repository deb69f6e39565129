// The node on an in-process CAN bus and LCM.
#include "firmware_emu/box_node.h"

#include <gtest/gtest.h>

#include "firmware_emu/box_report.h"
#include "lcmtypes/channels.h"
#include "platform/open_can_bus.h"
#include "tests/unit/firmware_emu/box_rig.h"

namespace eod::box {
namespace {

BoxNodeConfig ShippedConfig() {
  BoxNodeConfig config;
  config.dbc_file = EOD_DATA_DIR "/dbc/control_box.dbc";
  config.map_file = EOD_DATA_DIR "/dbc/control_box.map.toml";
  return config;
}

class Node : public testing::Test {
 protected:
  Node() { lcm_.subscribe("EOD_PANEL_STATUS", &Node::OnStatus, this); }

  void Start(const BoxNodeConfig& config) {
    box_bus_ = OpenCanBus("inproc:box_node_test", clock_);
    robot_bus_ = OpenCanBus("inproc:box_node_test", clock_);
    dut_.emplace(config, *box_bus_, lcm_, clock_);
  }
  void Run(int ms) {
    for (int i = 0; i < ms; ++i) {
      clock_.Advance(milliseconds(1));
      dut_->OnCan();
      dut_->OnTick(clock_.Now());
      while (lcm_.handleTimeout(0) > 0) {
      }
    }
  }
  void Command(std::vector<std::string> actions) {
    panel_command_t command{};
    command.num_actions = static_cast<int16_t>(actions.size());
    command.action = std::move(actions);
    lcm_.publish("EOD_PANEL_COMMAND", &command);
    while (lcm_.handleTimeout(0) > 0) {
    }
  }
  void OnStatus(const lcm::ReceiveBuffer*, const std::string&, const panel_status_t* status) {
    statuses_.push_back(*status);
  }

  ManualClock clock_;
  lcm::LCM lcm_{"memq://"};
  std::unique_ptr<CanBus> box_bus_;
  std::unique_ptr<CanBus> robot_bus_;
  std::optional<BoxNode> dut_;
  std::vector<panel_status_t> statuses_;
};

TEST_F(Node, SendsTheBoxesFramesAndHearsTheRobots) {
  Start(ShippedConfig());
  Run(600);
  int safety = 0;
  while (const auto frame = robot_bus_->Receive()) safety += frame->id == kSafetyId ? 1 : 0;
  EXPECT_GE(safety, 5);
  dbc::BoxCodec robot = ShippedCodec();
  robot_bus_->Send(*robot.Encode(dbc::RobotMessage::kPose, {.heading_deg = 45}));
  Run(1);
  EXPECT_EQ(dut_->status().feedback.heading_deg, 45);
  EXPECT_TRUE(dut_->status().link_up);
}

TEST_F(Node, PublishesItsStatusEvery100MillisecondsAndOnChange) {
  Start(ShippedConfig());
  Run(2000);  // boot, self-test, standby; link lost at 1001 ms and its lamp blinks from then on
  statuses_.clear();
  dut_->hands().Apply(ParseAction("power off"), clock_.Now());
  Run(1);
  ASSERT_EQ(statuses_.size(), 1u);
  EXPECT_EQ(statuses_[0].box_state, panel_status_t::BOX_OFF);
  Run(1000);
  EXPECT_EQ(statuses_.size(), 11u);
}

TEST_F(Node, DoesPanelCommandsAndShowsThem) {
  Start(ShippedConfig());
  Run(600);
  Command({"key operate", "press M01 M03"});
  Run(30);
  EXPECT_EQ(dut_->status().reported.key, dbc::KeySwitch::kOperate);
  EXPECT_EQ(statuses_.back().pressed, 0b101);
  EXPECT_EQ(statuses_.back().box_state, panel_status_t::BOX_READY);
}

TEST_F(Node, BadPanelCommandsAreCountedAndTheOthersDone) {
  Start(ShippedConfig());
  Run(600);
  Command({"levitate", "key operate", "press M99", ""});
  Run(30);
  EXPECT_EQ(dut_->bad_actions(), 3u);
  EXPECT_EQ(dut_->status().reported.key, dbc::KeySwitch::kOperate);
}

TEST_F(Node, PlaysItsScriptAndTellsWhatHappens) {
  BoxNodeConfig config = ShippedConfig();
  std::vector<std::string> told;
  config.tell = [&told](TimePoint, const std::string& line) { told.push_back(line); };
  config.script = ParseScript("wait state standby within 1s\nnote \"hello\"\nkey operate", "a");
  Start(config);
  Run(400);
  EXPECT_EQ(statuses_.back().script_line, "wait state standby within 1s");
  EXPECT_FALSE(dut_->is_script_done());
  Run(200);
  EXPECT_TRUE(dut_->is_script_done());
  EXPECT_FALSE(dut_->script_failure());
  EXPECT_EQ(told, (std::vector<std::string>{"box boot", "box self_test", "lamp power on",
                                            "box standby", "* hello", "script done", "box ready"}));
  EXPECT_TRUE(statuses_.back().script_done);
}

TEST_F(Node, KeepsTheReasonOfAFailedScript) {
  BoxNodeConfig config = ShippedConfig();
  config.script = ParseScript("expect link up", "a.boxscript");
  Start(config);
  Run(1);
  EXPECT_EQ(dut_->script_failure(), "a.boxscript:1: expect link up: link is down");
}

TEST_F(Node, ListensOnTheChannelsOfItsStation) {
  BoxNodeConfig config = ShippedConfig();
  config.channel_prefix = "B_";
  Start(config);
  Run(600);
  Command({"key operate"});
  Run(30);
  EXPECT_EQ(dut_->status().reported.key, dbc::KeySwitch::kOff);
  EXPECT_TRUE(statuses_.empty());
}

TEST_F(Node, AScriptSeesTheRobotInTheModulesFrameOnceBothMessagesFit) {
  BoxNodeConfig config = ShippedConfig();
  config.script = ParseScript("wait x >= 2.9 within 60s\nexpect y < 4.1\nexpect ahead can > 6.9\n",
                              "a.boxscript");
  Start(config);
  robot_state_t robot{};
  robot.module = 3;
  robot.position_m[0] = 1003;
  robot.position_m[1] = -496;
  scene_t scene{};
  scene.module = 1;
  scene.origin_m[0] = 1000;
  scene.origin_m[1] = -500;
  scene.num_objects = 1;
  scene.name = {"can"};
  scene.position_m = {{3, 11, 0}};
  scene.heading_deg = scene.tilt_deg = {0};
  scene.is_movable = scene.is_held = scene.is_gone = {0};
  lcm_.publish("EOD_ROBOT_STATE", &robot);
  lcm_.publish("EOD_SCENE", &scene);
  Run(2);
  EXPECT_FALSE(dut_->is_script_done()) << "of another module";
  scene.module = 3;
  lcm_.publish("EOD_SCENE", &scene);
  Run(2);
  EXPECT_TRUE(dut_->is_script_done());
  EXPECT_EQ(dut_->script_failure(), std::nullopt);
}

TEST_F(Node, TwoRunsSendTheSameFrames) {
  const auto run = [this](const std::string& bus) {
    ManualClock clock;
    lcm::LCM lcm("memq://");
    BoxNodeConfig config = ShippedConfig();
    config.script = LoadScript(EOD_DATA_DIR "/firmware_emu/scripts/first_drive.boxscript");
    const auto box_bus = OpenCanBus(bus, clock);
    const auto other = OpenCanBus(bus, clock);
    BoxNode node(config, *box_bus, lcm, clock);
    std::vector<CanFrame> frames;
    for (int i = 0; i < 8000; ++i) {
      clock.Advance(milliseconds(1));
      node.OnTick(clock.Now());
      while (auto frame = other->Receive()) frames.push_back(*frame);
    }
    return frames;
  };
  const auto first = run("inproc:first");
  const auto second = run("inproc:second");
  ASSERT_EQ(first.size(), second.size());
  EXPECT_GT(first.size(), 1000u);
  for (size_t i = 0; i < first.size(); ++i) EXPECT_TRUE(SameOnWire(first[i], second[i])) << i;
}

TEST(Description, NamesRatesAndChannels) {
  const std::string text = Describe(ShippedConfig(), "inproc:a");
  for (const auto* part : {"inproc:a", "BOX_SAFETY     every 20 ms", "BOX_EMCY       on events",
                           "EOD_PANEL_COMMAND", "EOD_PANEL_STATUS"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
}

}  // namespace
}  // namespace eod::box
