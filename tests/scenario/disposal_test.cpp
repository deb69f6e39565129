#include <gtest/gtest.h>

#include "tests/scenario/operator_script.h"

namespace eod::lockstep {
namespace {

using namespace std::chrono_literals;

const std::filesystem::path kPickUp = kData / "firmware_emu/scripts/bomb_ground.boxscript";

std::string Open(double metres) {
  return fmt::format("hold M17 until joint 7 >= {} within 4s\n", metres);
}

/// At charge M, the gripper round it and open; `last_m` is the last, creeping bit of the way.
std::string AroundChargeM(double last_m = 0.238) {
  return PowerUp("bomb") +
         "speed low\nhold preset ground_pick until joint 4 >= 108.6 within 20s\n" + Open(0.08) +
         "hold M01 until travel >= 4.5 within 30s\nwait 500ms\nspeed creep\n" +
         fmt::format("hold M01 until travel >= {} within 30s\nwait 1s\n", last_m);
}

std::string TakeChargeM() {
  return AroundChargeM() +
         "hold M18 until grasp grasped within 6s\nwait 500ms\nhold M09 for 2s\nwait 500ms\n";
}

TEST(Disposal, ChargeFromTheGroundEndsInTheCan) {
  Mission dut(box::LoadScript(kPickUp), ShippedScenario("bomb_ground_m"));
  PlayScript(dut, 300s);
  const sim::StepResult& last = dut.rig().simulator().last();
  EXPECT_EQ(last.task.state, sim::MissionState::kSuccess);
  EXPECT_EQ(last.disposal.bomb, sim::BombState::kInCan);
}

TEST(Disposal, TwoRunsGiveTheSameBits) {
  Mission first(box::LoadScript(kPickUp), ShippedScenario("bomb_ground_m"));
  Mission second(box::LoadScript(kPickUp), ShippedScenario("bomb_ground_m"));
  ASSERT_TRUE(first.Run(300s));
  ASSERT_TRUE(second.Run(300s));
  EXPECT_TRUE(first.can_log() == second.can_log());
  EXPECT_TRUE(first.states() == second.states());
}

TEST(Disposal, ChargeDroppedOnTheGroundGoesOff) {
  Mission dut = RunMission(TakeChargeM() +
                               "hold M17 for 1s\nwait bomb exploded within 3s\n"
                               "wait mission fail within 1s\nexpect failure exploded\n",
                           "bomb_ground_m");
  PlayScript(dut, 120s);
  const sim::DisposalStatus& disposal = dut.rig().simulator().last().disposal;
  EXPECT_EQ(disposal.detonation, sim::DetonationCause::kDropped);
  EXPECT_TRUE(disposal.robot_destroyed);
}

TEST(Disposal, PushingOnAfterTheAlarmTopplesTheChargeWhichGoesOff) {
  // The closed hand high on the charge, straight into it.
  Mission dut = RunMission(PowerUp("bomb") +
                               "speed low\nhold preset ground_pick until joint 4 >= 108.6 within "
                               "20s\nhold M09 for 1s\nwait 500ms\nhold M01 until travel >= 4.3 "
                               "within 30s\nspeed creep\npress M01\nwait bomb touched within 15s\n"
                               "wait alarm any within 1s\nwait bomb exploded within 30s\n"
                               "expect failure exploded\n",
                           "bomb_ground_m");
  PlayScript(dut, 120s);
  EXPECT_EQ(dut.rig().simulator().last().disposal.detonation, sim::DetonationCause::kTipped);
}

/// Moves joint `joint` [deg] to `target` with motion `motion`, the last degrees slowly.
std::string MoveJoint(int joint, double target, std::string_view motion, bool down) {
  const double sign = down ? 1 : -1;
  return fmt::format(
      "rate 100%\nhold {0} until joint {1} {2} {3} within 30s\nrate 10%\n"
      "hold {0} until joint {1} {2} {4} within 30s\nrate 100%\nwait 300ms\n",
      motion, joint, down ? "<=" : ">=", target + sign * 4, target + sign * 0.05);
}

constexpr std::string_view kTakeAndLift =
    "wait 500ms\nhold M18 until grasp grasped within 6s\nwait 500ms\nhold M09 for 2s\n"
    "wait bomb carried within 1s\nexpect lamp grasp on\n";

TEST(Disposal, SmallChargeIsTakenFromTheTable) {
  Mission dut = RunMission(PowerUp("bomb") + DriveAhead(2) + TurnTo(90, true) + DriveAhead(4) +
                               TurnTo(0.25, false) + MoveJoint(3, 54.3, "M10", true) +
                               MoveJoint(4, 99.3, "M11", false) + MoveJoint(5, 26.4, "M14", true) +
                               Open(0.05) + DriveAhead(2.85) + std::string(kTakeAndLift),
                           "bomb_table_s");
  PlayScript(dut, 120s);
}

TEST(Disposal, LargeChargeIsTakenUnderTheBench) {
  Mission dut =
      RunMission(PowerUp("bomb") + DriveAhead(2) + TurnTo(270, false) + DriveAhead(4) +
                     TurnTo(359.75, true) + MoveJoint(4, 123.9, "M11", false) +
                     MoveJoint(3, 7.0, "M10", true) + MoveJoint(5, 49.1, "M13", false) + Open(0.1) +
                     DriveAhead(2.70) + "wait 500ms\nhold M18 until grasp grasped within 8s\n",
                 "bomb_bench_l");
  PlayScript(dut, 120s);
}

TEST(Disposal, ChargeSqueezedOffItsMiddleGoesOff) {
  // 38 mm short of the middle: the five lines never agree.
  Mission dut = RunMission(
      AroundChargeM(0.2) + "press M18\nwait bomb exploded within 8s\nexpect failure exploded\n",
      "bomb_ground_m");
  PlayScript(dut, 120s);
  EXPECT_EQ(dut.rig().simulator().last().disposal.detonation, sim::DetonationCause::kSqueezed);
}

TEST(Disposal, ChargeCarriedIntoTheRimGoesOff) {
  Mission dut = RunMission(TakeChargeM() +
                               "hold preset carry until joint 3 >= 70.0 within 20s\nspeed low\n"
                               "press M01\nwait bomb exploded within 60s\n",
                           "bomb_ground_m");
  PlayScript(dut, 200s);
  EXPECT_EQ(dut.rig().simulator().last().disposal.detonation, sim::DetonationCause::kRimStrike);
}

TEST(Disposal, DisrupterFiresOnlyWithKeyCircuitAndBothHands) {
  const std::string armed = PowerUp("bomb") +
                            "arm_key safe\nwait 200ms\narm_key armed\n"
                            "circuit 1\nwait fire ready within 3s\n";
  Mission one_hand =
      RunMission(armed + "fire_left pressed\nwait 1s\nexpect not fire fired\n", "bomb_disrupt");
  PlayScript(one_hand, 60s);
  Mission both = RunMission(armed +
                                "fire_left pressed\nwait 100ms\nfire_right pressed\n"
                                "wait fire fired within 2s\nwait lamp fired on within 1s\n",
                            "bomb_disrupt");
  PlayScript(both, 60s);
}

}  // namespace
}  // namespace eod::lockstep
