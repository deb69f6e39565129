#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lcmtypes/channels.h"
#include "platform/clock.h"
#include "sim/sim_node.h"
#include "tests/unit/behaviour/operator.h"

namespace eod::sim {
namespace {

using std::chrono::milliseconds;
using Kind = ControlLinkSpec::Kind;

Scenario WithLink(const ControlLinkSpec& link) {
  Scenario scenario = FirstDrive();
  scenario.link = link;
  return scenario;
}

/// A node in virtual time, 4 ms a tick, and all that it said.
class LinkNode {
 public:
  explicit LinkNode(const ControlLinkSpec& link)
      : dut({.channel_prefix = {}, .simulator = WithRules()}, TheSharpRobot(), TheWorld(),
            WithLink(link), lcm, clock) {
    lcm.subscribe(ChannelName("", kRobotStateChannel), &LinkNode::OnState, this);
    lcm.subscribe(ChannelName("", kTelemetryStateChannel), &LinkNode::OnTelemetry, this);
    command.motion_permitted = 1;
    command.speed_range = 1;
  }

  void Tick(int times = 1) {
    for (int i = 0; i < times; ++i) {
      clock.Advance(milliseconds(4));
      Step();
    }
  }
  /// A command at the moment of each tick, with these motions.
  void Hold(std::initializer_list<int> motions, int ticks) {
    for (double& rate : command.motion_rate) rate = 0;
    for (const int motion : motions) command.motion_rate[motion] = 1;
    for (int i = 0; i < ticks; ++i) {
      clock.Advance(milliseconds(4));
      ++command.sequence;
      lcm.publish(ChannelName("", kBoxCommandChannel), &command);
      Deliver();
      Step();
    }
  }
  /// A mission of its own: forward, a turn, and the arm.
  void Drive() {
    Hold({}, 20);
    Hold({kDriveForward}, 200);
    Hold({kTurnLeft, kBigArmDown}, 150);
    Hold({}, 200);
  }

  struct Heard {
    TimePoint time;
    robot_state_t state;
  };
  lcm::LCM lcm{"memq://"};
  ManualClock clock{TimePoint{std::chrono::seconds(1000)}};
  SimNode dut;
  box_command_t command{};
  std::vector<robot_state_t> states;
  std::vector<Heard> telemetry;

 private:
  void Step() {
    dut.OnTick(clock.Now());
    Deliver();
  }
  void Deliver() {
    while (lcm.handleTimeout(0) > 0) {
    }
  }
  void OnState(const lcm::ReceiveBuffer*, const std::string&, const robot_state_t* message) {
    states.push_back(*message);
  }
  void OnTelemetry(const lcm::ReceiveBuffer*, const std::string&, const robot_state_t* message) {
    telemetry.push_back({clock.Now(), *message});
  }
};

void ExpectSamePose(const robot_state_t& a, const robot_state_t& b) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(a.position_m[axis], b.position_m[axis]);
  EXPECT_EQ(a.heading_deg, b.heading_deg);
  for (int j = 0; j < kJointCount; ++j) EXPECT_EQ(a.joint[j], b.joint[j]);
}

TEST(LinkNode, ADelayOfCommandsShiftsThePosesByExactlyThat) {
  LinkNode direct({});
  direct.Drive();
  for (const int steps : {25, 50, 125}) {  // 100, 200 and 500 ms
    LinkNode late({.commands = {.delay = 0.004 * steps}});
    late.Drive();
    ASSERT_EQ(late.states.size(), direct.states.size());
    for (size_t i = 0; i + steps < late.states.size(); i += 10) {
      ExpectSamePose(late.states[i + steps], direct.states[i]);
    }
  }
}

TEST(LinkNode, ALinkWithoutDelayChangesNothingButWhatItSaysOfItself) {
  LinkNode direct({}), radio({.kind = Kind::kRadio, .range = 5000});
  direct.Drive();
  radio.Drive();
  for (size_t i = 0; i < direct.states.size(); ++i) {
    ExpectSamePose(direct.states[i], radio.states[i]);
    EXPECT_EQ(direct.states[i].inhibit_mask, radio.states[i].inhibit_mask);
  }
  EXPECT_TRUE(direct.telemetry.empty());
  EXPECT_EQ(direct.states.back().relayed, 0);
  EXPECT_EQ(direct.states.back().link_quality, 1);
  // All of it in the step that it tells of.
  ASSERT_EQ(radio.telemetry.size(), radio.states.size());
  EXPECT_EQ(ToUtime(radio.telemetry.back().time), radio.telemetry.back().state.utime);
  EXPECT_NE(radio.states.back().relayed, 0);
  EXPECT_LT(radio.states.back().link_quality, 1);
}

TEST(LinkNode, TelemetryArrivesByItsOwnDelayAndTheTruthAtOnce) {
  LinkNode dut({.telemetry = {.delay = 0.3}});
  dut.Hold({kDriveForward}, 200);
  ASSERT_EQ(dut.states.size(), 200u);
  ASSERT_EQ(dut.telemetry.size(), 200u - 75);
  for (const LinkNode::Heard& heard : dut.telemetry) {
    EXPECT_EQ(ToUtime(heard.time) - heard.state.utime, 300'000);
  }
  ExpectSamePose(dut.telemetry.back().state, dut.states[124]);
}

TEST(LinkNode, LostTelemetryNeverComes) {
  LinkNode dut({.telemetry = {.loss = 0.2}});
  dut.Tick(2000);
  // 2000 states, and a tenth as many alarms and missions that draw too: 4 sigma of 18.
  EXPECT_NEAR(static_cast<double>(dut.telemetry.size()), 1600, 4 * 18);
}

TEST(LinkNode, SilenceRampsTheRobotDownAndLatches) {
  LinkNode dut({.kind = Kind::kRadio, .range = 5000});
  dut.Hold({kDriveForward}, 100);
  dut.Tick(25);
  EXPECT_NEAR(dut.states.back().speed_mps, 0.30, 1e-12);
  EXPECT_EQ(dut.states.back().command_age_ms, 100);
  dut.Tick(25);  // 200 ms old: half of the ramp
  EXPECT_NEAR(dut.states.back().speed_mps, 0.15, 1e-9);
  EXPECT_EQ(dut.states.back().inhibit_reason, kReasonLinkLoss);
  dut.Tick(25);
  EXPECT_EQ(dut.states.back().speed_mps, 0);
  EXPECT_FALSE(dut.states.back().link_latched);
  dut.Tick(51);
  EXPECT_TRUE(dut.states.back().link_latched);
  dut.Hold({}, 10);
  dut.Hold({kDriveForward}, 10);
  EXPECT_EQ(dut.states.back().speed_mps, 0) << "latched";
  ++dut.command.resets;
  dut.Hold({kDriveForward}, 10);
  EXPECT_EQ(dut.states.back().speed_mps, 0) << "not neutral yet";
  EXPECT_EQ(dut.states.back().inhibit_reason, kReasonNeutralNeeded);
  dut.Hold({}, 1);
  dut.Hold({kDriveForward}, 10);
  EXPECT_NEAR(dut.states.back().speed_mps, 0.30, 1e-12);
}

TEST(LinkNode, PicturesAreShownLateByTheirDelayAndCarryTheQuality) {
  LinkNode dut({.kind = Kind::kRadio, .pictures = {.delay = 0.2}, .range = 100});
  struct Shown {
    TimePoint time;
    SceneSnapshot scene;
  };
  std::vector<Shown> shown;
  dut.dut.SetSceneOutput({.show =
                              [&](const SceneSnapshot& scene) {
                                shown.push_back({dut.clock.Now(), scene});
                              },
                          .period = milliseconds(40)});
  dut.Hold({kDriveForward}, 250);
  ASSERT_EQ(shown.size(), 20u);  // 25 were taken, 5 are under way
  for (const Shown& each : shown) EXPECT_EQ(each.time - each.scene.time, milliseconds(200));
  const float expected = static_cast<float>(dut.states[199].link_quality);
  EXPECT_NEAR(shown.back().scene.link_quality, expected, 0.01F);
  EXPECT_LT(shown.back().scene.link_quality, 0.995F);
}

TEST(LinkNode, TwoRunsGiveTheSameBits) {
  const ControlLinkSpec spec{.kind = Kind::kRadio,
                             .commands = {.delay = 0.1, .jitter = 0.1, .loss = 0.2},
                             .telemetry = {.delay = 0.1, .jitter = 0.1, .loss = 0.2}};
  LinkNode first(spec), second(spec);
  first.Drive();
  second.Drive();
  ASSERT_EQ(first.telemetry.size(), second.telemetry.size());
  for (size_t i = 0; i < first.telemetry.size(); ++i) {
    EXPECT_EQ(first.telemetry[i].time, second.telemetry[i].time);
    ExpectSamePose(first.telemetry[i].state, second.telemetry[i].state);
  }
}

TEST(Simulator, CablesEndStopsTheRobotWithItsReasonAndTheWayBackIsFree) {
  constexpr double kLength = 2.0;
  Simulator dut(TheSharpRobot(), TheWorld(),
                WithLink({.kind = Kind::kCable, .cable_length = kLength}), WithRules());
  OperatorCommand command;
  command.motion_permitted = true;
  TimePoint now{};
  const auto hold = [&](int motion, int steps) {
    command.motion_rate = {};
    command.motion_rate[motion] = 1;
    for (int i = 0; i < steps; ++i) {
      command.stamp = now += milliseconds(4);
      dut.Step(now, command);
    }
  };
  hold(kDriveForward, 2000);  // 2.4 m at 0.30 m/s
  EXPECT_GE(dut.last().cable_out, kLength);
  EXPECT_LT(dut.last().cable_out, kLength + 0.3 * 0.004 + 1e-9);
  EXPECT_EQ(dut.last().speed, 0);
  EXPECT_EQ(dut.last().inhibit_reason, kReasonCable);
  EXPECT_EQ(dut.last().inhibited, SetOf(kDriveForward));
  const double y = dut.last().state.position.y();
  hold(kDriveReverse, 250);
  EXPECT_NEAR(dut.last().state.position.y(), y - 0.3, 1e-6);
  EXPECT_EQ(dut.last().inhibited, 0u);
}

}  // namespace
}  // namespace eod::sim
