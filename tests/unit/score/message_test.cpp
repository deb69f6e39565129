// A judge that hears the messages knows as much as the one in the simulator.
#include <gtest/gtest.h>

#include "sim/message_node.h"
#include "tests/unit/behaviour/operator.h"

namespace eod::sim {
namespace {

/// What arrives of the last step at the other end of LCM.
robot_state_t Arrived(const Simulator& simulator) {
  robot_state_t sent{};
  Fill(simulator, sent);
  std::vector<uint8_t> bytes(static_cast<size_t>(sent.getEncodedSize()));
  sent.encode(bytes.data(), 0, static_cast<unsigned>(bytes.size()));
  robot_state_t arrived{};
  EXPECT_GT(arrived.decode(bytes.data(), 0, static_cast<unsigned>(bytes.size())), 0);
  return arrived;
}

void ExpectSame(const ScoreSample& a, const ScoreSample& b) {
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.module, b.module);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(
      std::tie(a.heading_deg, a.pitch_deg, a.roll_deg, a.speed_mps, a.turn_rate_dps, a.joint),
      std::tie(b.heading_deg, b.pitch_deg, b.roll_deg, b.speed_mps, b.turn_rate_dps, b.joint));
  EXPECT_EQ(
      std::tie(a.limit_flags, a.inhibit_mask, a.contact_parts, a.wanted_mask, a.blocked_mask),
      std::tie(b.limit_flags, b.inhibit_mask, b.contact_parts, b.wanted_mask, b.blocked_mask));
  EXPECT_EQ(std::tie(a.held_object, a.contact_object, a.contact_by_held, a.ahead_object, a.charge),
            std::tie(b.held_object, b.contact_object, b.contact_by_held, b.ahead_object, b.charge));
  EXPECT_EQ(std::tie(a.fire_state, a.system_state, a.speed_range, a.camera_select, a.horn,
                     a.arm_key, a.fire_left, a.fire_right, a.checks),
            std::tie(b.fire_state, b.system_state, b.speed_range, b.camera_select, b.horn,
                     b.arm_key, b.fire_left, b.fire_right, b.checks));
  EXPECT_EQ(a.ahead_m, b.ahead_m);
  EXPECT_EQ(a.charge_position, b.charge_position);
  EXPECT_EQ(a.charge_low_m, b.charge_low_m);
  EXPECT_EQ(a.charge_in_hand, b.charge_in_hand);
  EXPECT_EQ(a.charge_touched, b.charge_touched);
  EXPECT_EQ(a.bomb_state, b.bomb_state);
  EXPECT_TRUE(std::equal(a.moved_m.begin(), a.moved_m.end(), b.moved_m.begin(), b.moved_m.end()));
  EXPECT_EQ(std::tie(a.mission_state, a.mission_step, a.fail_reason, a.mission_s),
            std::tie(b.mission_state, b.mission_step, b.fail_reason, b.mission_s));
}

TEST(RobotStateMessage, HoldsAllThatTheJudgeIsTold) {
  Operator op;
  Scorer listener(FirstDrive(), TheWorld().Module(1), WithRules().exercise);
  const auto step = [&](int times) {
    for (int i = 0; i < times; ++i) {
      op.Step();
      const robot_state_t arrived = Arrived(op.dut);
      const ScoreSample heard = ToSample(arrived);
      ExpectSame(heard, op.dut.score_sample());
      listener.Advance(heard);
    }
  };
  op.command.menu_module = 1;
  op.command.menu_command = kMenuStart;
  step(1);
  op.Press({kFrontFlipperDown, kRearFlipperDown});
  step(1150);
  op.command.horn = true;
  op.command.fire = {.arm_key = 2, .fire_left = 1, .fire_right = 2, .circuit = 1, .nonce_echo = 0};
  op.Press({kDriveForward, kBigArmDown, kGripperOpen});
  step(4500);
  op.Press({kDriveReverse, kTurnLeft});
  step(300);
  EXPECT_GT(listener.Sheet().events.size(), 3u);
  EXPECT_EQ(listener.Sheet(), op.dut.scorer().Sheet());
}

TEST(RobotStateMessage, TellsWhereAChargeIs) {
  const Scenario scenario = LoadScenario(kData / "sim/scenarios/bomb_ground_m.toml");
  Simulator dut(TheRobot(), TheWorld(), scenario, WithRules());
  dut.Step(TimePoint{} + std::chrono::seconds(1), {});
  const robot_state_t message = Arrived(dut);
  ExpectSame(ToSample(message), dut.score_sample());
  const ModuleModel& module = dut.module();
  const MovableObject* charge = nullptr;
  for (const MovableObject& one : module.movables) {
    if (one.name == message.charge) charge = &one;
  }
  ASSERT_NE(charge, nullptr);
  const Eigen::Vector3d p_W = module.p_WM + charge->X_MO.translation();
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(message.charge_m[i], p_W[i], 1e-3);
  EXPECT_NEAR(message.charge_low_m, p_W.z() - charge->explosive->half_height, 2e-3);
  EXPECT_EQ(message.num_movables, static_cast<int16_t>(module.movables.size()));
  for (const double moved : message.moved_m) EXPECT_LT(moved, 2e-3);
}

TEST(BoxChecks, AreKeptFromBeforeTheMissionUntilItEnds) {
  Operator op;
  const auto checks = [&op] { return op.dut.score_sample().checks; };
  op.Step();
  EXPECT_EQ(checks(), kDriveCameraSeen);
  op.command.system_state = 5;
  op.Step();
  EXPECT_EQ(checks(), kDriveCameraSeen);  // latched, and not left yet
  op.command.system_state = 3;
  op.command.lamp_test = true;
  op.Step();
  op.command.lamp_test = false;
  for (const int camera : {2, 3, 4, 0}) {
    op.command.camera_select = camera;
    op.Step();
  }
  EXPECT_EQ(checks(), kEstopTested | kLampsTested | kAllCamerasSeen);
  op.command.menu_module = 1;
  op.command.menu_command = kMenuStart;
  op.Step();
  op.command.menu_command = kMenuEnd;
  op.Step();
  EXPECT_EQ(checks(), kEstopTested | kLampsTested | kAllCamerasSeen);
  op.Step();
  EXPECT_EQ(checks(), 0u);
}

}  // namespace
}  // namespace eod::sim
