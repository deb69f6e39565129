#include <gtest/gtest.h>

#include "lcmtypes/channels.h"
#include "platform/clock.h"
#include "sim/sim_node.h"
#include "tests/unit/behaviour/operator.h"

namespace eod::sim {
namespace {

using std::chrono::milliseconds;
using Kind = FaultSpec::Kind;
constexpr double kStep = 0.004;  // [s]

/// The shipped robot on the flat module, its mission running, with one fault from the start.
struct FaultyRobot {
  explicit FaultyRobot(FaultSpec fault, const ControlLinkSpec& link = {})
      : dut(TheSharpRobot(), TheWorld(), Exercise(std::move(fault), link),
            WithRules({.start_mission = true})) {
    command.motion_permitted = true;
    Hold({}, 1);  // the mission starts, so the fault begins in the next step
  }
  static Scenario Exercise(FaultSpec fault, const ControlLinkSpec& link) {
    Scenario scenario = FirstDrive();
    if (!fault.at) fault.at = 0;
    scenario.faults = {fault};
    scenario.link = link;
    return scenario;
  }
  void Hold(std::initializer_list<int> motions, int steps) {
    command.motion_rate = {};
    for (const int motion : motions) command.motion_rate[motion] = 1;
    for (int i = 0; i < steps; ++i) {
      command.stamp = now += milliseconds(4);
      dut.Step(now, command);
    }
  }
  const StepResult& last() const { return dut.last(); }
  double joint(int j) const { return last().state.joint[j]; }

  Simulator dut;
  OperatorCommand command;
  TimePoint now{};
};

TEST(FaultyRobot, StuckJointStaysWhereItIsAndNothingSaysSo) {
  FaultyRobot dut({.kind = Kind::kJointStuck, .target = "J3"});
  const double before = dut.joint(kBigArm), other = dut.joint(kSmallArm);
  dut.Hold({kBigArmDown, kSmallArmUp}, 100);
  EXPECT_EQ(dut.joint(kBigArm), before);
  EXPECT_NEAR(dut.joint(kSmallArm), other + 100 * kStep * TheRobot().joints[kSmallArm].rate, 1e-9);
  EXPECT_EQ(dut.last().inhibited, 0u);
}

TEST(FaultyRobot, SlowJointMovesByItsShare) {
  FaultyRobot dut({.kind = Kind::kJointSlow, .target = "J4", .amount = 0.25});
  const double before = dut.joint(kSmallArm);
  dut.Hold({kSmallArmUp}, 100);
  const double rate = TheRobot().joints[kSmallArm].rate;
  EXPECT_NEAR(dut.joint(kSmallArm), before + 0.25 * 100 * kStep * rate, 1e-9);
}

TEST(FaultyRobot, DriftingJointMovesWithoutACommand) {
  FaultyRobot dut({.kind = Kind::kJointDrift, .target = "J9", .amount = 1.5});
  const double before = dut.joint(kCameraTilt);
  dut.Hold({}, 500);
  EXPECT_NEAR(dut.joint(kCameraTilt), before + 500 * kStep * 1.5 * kDegree, 1e-9);
}

TEST(FaultyRobot, WeakTrackBendsTheWayIntoAnArc) {
  FaultyRobot dut({.kind = Kind::kTrackWeak, .target = "right", .amount = 0.8});
  dut.Hold({kDriveForward}, 1000);
  const double v = 0.30, turn = v * 0.2 / TheRobot().track * 1000 * kStep;  // to the right
  EXPECT_NEAR(dut.last().state.attitude.heading, 2 * std::numbers::pi - turn, 1e-6);
  const double radius = 0.9 * v / (v * 0.2 / TheRobot().track);
  EXPECT_NEAR(dut.last().state.position.x(), radius * (1 - std::cos(turn)), 0.01);
  EXPECT_NEAR(dut.last().state.position.y(), radius * std::sin(turn), 0.01);
}

TEST(FaultyRobot, FieldEmergencyStopHoldsEverythingUntilItIsReleased) {
  FaultyRobot dut({.kind = Kind::kFieldEstop, .at = 0.4, .duration = 1.0});
  dut.Hold({kDriveForward}, 99);
  EXPECT_NEAR(dut.last().speed, 0.30, 1e-12);
  dut.Hold({kDriveForward}, 3);
  EXPECT_EQ(dut.last().speed, 0);
  EXPECT_EQ(dut.last().inhibit_reason, kReasonEstop);
  EXPECT_TRUE(dut.last().field_estop);
  const double y = dut.last().state.position.y();
  dut.Hold({kDriveForward}, 200);
  EXPECT_EQ(dut.last().state.position.y(), y);
  dut.Hold({kDriveForward}, 60);
  EXPECT_GT(dut.last().state.position.y(), y);
}

TEST(FaultyRobot, StuckButtonDrivesWhileTheEnablingSwitchIsHeld) {
  FaultyRobot dut({.kind = Kind::kStuckButton, .target = "M02"});
  dut.Hold({}, 100);
  EXPECT_NEAR(dut.last().state.position.y(), -100 * kStep * 0.30, 1e-9);
  dut.command.motion_permitted = false;
  dut.Hold({}, 10);
  EXPECT_EQ(dut.last().speed, 0);
  // The other direction is a conflict: both are refused.
  dut.command.motion_permitted = true;
  dut.Hold({kDriveForward}, 10);
  EXPECT_EQ(dut.last().speed, 0);
  EXPECT_EQ(dut.last().inhibit_reason, kReasonConflict);
}

TEST(FaultyRobot, SaggingBatteryIsAnAlarm) {
  const BatterySpec& spec = TheRobot().battery;
  FaultyRobot dut({.kind = Kind::kBatterySag, .amount = spec.full - spec.low});
  EXPECT_FALSE(dut.dut.alarms().IsActive(AlarmCode::kBattery));
  const double before = dut.last().battery_v;
  dut.Hold({}, 2);
  EXPECT_NEAR(dut.last().battery_v, before - (spec.full - spec.low), 1e-3);
  EXPECT_TRUE(dut.dut.alarms().IsActive(AlarmCode::kBattery));
}

TEST(FaultyRobot, SnaggedCableHoldsTheRobotWhereItIsUntilItIsFree) {
  FaultyRobot dut({.kind = Kind::kCableSnag, .at = 1.0, .duration = 2.0},
                  {.kind = ControlLinkSpec::Kind::kCable, .cable_length = 50});
  dut.Hold({kDriveForward}, 600);
  EXPECT_NEAR(dut.last().state.position.y(), 0.30 * 1.0, 0.30 * 3 * kStep);
  EXPECT_EQ(dut.last().inhibit_reason, kReasonCable);
  dut.Hold({kDriveForward}, 300);
  EXPECT_GT(dut.last().state.position.y(), 0.30 * 1.4);
}

TEST(FaultyRobot, RadioLossLetsNothingThroughForItsTime) {
  FaultyRobot dut({.kind = Kind::kRadioLoss, .at = 0.4, .duration = 3.0});
  dut.Hold({}, 50);
  EXPECT_EQ(dut.dut.link().drop_chance(), 0);
  dut.Hold({}, 100);
  EXPECT_EQ(dut.dut.link().drop_chance(), 1);
  EXPECT_EQ(dut.last().link_quality, 0);
  dut.Hold({}, 750);
  EXPECT_EQ(dut.dut.link().drop_chance(), 0);
}

TEST(FaultyRobot, CameraFaultsAreThereForTheCameras) {
  FaultyRobot dut({.kind = Kind::kCameraFrozen, .target = "mast"});
  dut.Hold({}, 1);
  for (size_t i = 0; i < TheRobot().cameras.size(); ++i) {
    const int expected = TheRobot().cameras[i].name == "mast" ? kCameraFrozenBit : 0;
    EXPECT_EQ(dut.dut.faults().active().camera[i], expected);
  }
}

/// The node's messages about a fault.
struct FaultyNode {
  explicit FaultyNode(FaultSpec fault)
      : dut({.channel_prefix = {}, .simulator = WithRules({.start_mission = true})},
            TheSharpRobot(), TheWorld(), FaultyRobot::Exercise(std::move(fault), {}), lcm, clock) {
    lcm.subscribe(ChannelName("", kRobotStateChannel), &FaultyNode::OnState, this);
    lcm.subscribe(ChannelName("", kTelemetryStateChannel), &FaultyNode::OnTelemetry, this);
    lcm.subscribe(ChannelName("", kFaultEventChannel), &FaultyNode::OnFault, this);
  }
  void Tick(int times) {
    for (int i = 0; i < times; ++i) {
      clock.Advance(milliseconds(4));
      dut.OnTick(clock.Now());
      while (lcm.handleTimeout(0) > 0) {
      }
    }
  }
  lcm::LCM lcm{"memq://"};
  ManualClock clock{TimePoint{std::chrono::seconds(1000)}};
  SimNode dut;
  robot_state_t state{}, telemetry{};
  std::vector<fault_event_t> events;

 private:
  void OnState(const lcm::ReceiveBuffer*, const std::string&, const robot_state_t* message) {
    state = *message;
  }
  void OnTelemetry(const lcm::ReceiveBuffer*, const std::string&, const robot_state_t* message) {
    telemetry = *message;
  }
  void OnFault(const lcm::ReceiveBuffer*, const std::string&, const fault_event_t* message) {
    events.push_back(*message);
  }
};

TEST(FaultyNode, SensorOffsetIsWhatTheOperatorSeesAndNotWhatIsTrue) {
  FaultyNode dut({.kind = Kind::kSensorOffset, .target = "J3", .amount = 7.5});
  dut.Tick(5);
  EXPECT_NE(dut.state.relayed, 0);
  EXPECT_NEAR(dut.state.joint[kBigArm], 120, 1e-9);
  EXPECT_NEAR(dut.telemetry.joint[kBigArm], 127.5, 1e-9);
  EXPECT_EQ(dut.telemetry.joint[kWrist], dut.state.joint[kWrist]);
  EXPECT_EQ(dut.telemetry.step, dut.state.step);
}

TEST(FaultyNode, BrokenLampAndFieldStopAreToldToTheBridge) {
  FaultyNode lamp({.kind = Kind::kLampBroken, .target = "tilt"});
  lamp.Tick(5);
  EXPECT_EQ(lamp.state.dark_lamps, 1 << 6);
  FaultyNode stop({.kind = Kind::kFieldEstop});
  stop.Tick(5);
  EXPECT_NE(stop.state.field_estop, 0);
}

TEST(FaultyNode, TheLogIsToldWhenAFaultBeginsAndEnds) {
  FaultyNode dut(
      {.kind = Kind::kJointSlow, .target = "J4", .amount = 0.5, .at = 0.04, .duration = 0.08});
  dut.Tick(100);
  ASSERT_EQ(dut.events.size(), 2u);
  EXPECT_TRUE(dut.events[0].begins);
  EXPECT_FALSE(dut.events[1].begins);
  EXPECT_EQ(dut.events[1].step - dut.events[0].step, 20);
  EXPECT_EQ(dut.events[0].code, fault_event_t::CODE_FAULT);
  EXPECT_EQ(dut.events[0].kind, "joint_slow");
  EXPECT_EQ(dut.events[0].target, "J4");
  EXPECT_EQ(dut.events[0].amount, 0.5);
}

}  // namespace
}  // namespace eod::sim
