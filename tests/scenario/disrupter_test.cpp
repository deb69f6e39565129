// The disrupter: who may fire, and what a shot does by aim and distance.
#include <gtest/gtest.h>

#include "tests/scenario/charge_script.h"

namespace eod::lockstep {
namespace {

using namespace std::chrono_literals;

const std::string kArm =
    "arm_key safe\nwait 200ms\narm_key armed\ncircuit 1\n"
    "wait fire ready within 3s\n";
const std::string kFire = "wait 500ms\n" + kArm +
                          "fire_left pressed\nwait 100ms\nfire_right pressed\n"
                          "wait fire fired within 2s\nfire_left released\nfire_right released\n"
                          "arm_key safe\nwait 500ms\n";

/// Robot at y = 2 + `ahead` before charge H. The wrist is 0.95 m ahead and 0.45 m high and looks
/// down by 25 degrees, `up` more or less: the muzzle, 0.10 m before and 0.11 m above it, is then
/// 1.087 m ahead and 0.507 m high, and its line is as high as the middle of H, 0.15 m, 0.767 m on.
std::string AimAtChargeH(double ahead, double up_deg = 0) {
  return ToChargeLane(8) + MoveJoint(4, 97.5, "M11", false) + MoveJoint(3, 32.2, "M10", true) +
         (up_deg > 4 ? MoveJoint(5, 25.3 + up_deg, "M13", false)
                     : MoveJoint(5, 25.3 + up_deg, "M14", true)) +
         DriveAhead(ahead) + kFire;
}
constexpr double kOnTarget = 6 - 1.087 - 0.767 - 2;

TEST(Disrupter, FiresOnlyWithKeyCircuitAndBothHands) {
  const std::string armed = PowerUp("bomb") + kArm;
  Mission one_hand =
      RunMission(armed + "fire_left pressed\nwait 1s\nexpect not fire fired\n", "bomb_disrupt");
  PlayScript(one_hand, 60s);
  Mission both = RunMission(armed +
                                "fire_left pressed\nwait 100ms\nfire_right pressed\n"
                                "wait fire fired within 2s\nwait lamp fired on within 1s\n",
                            "bomb_disrupt");
  PlayScript(both, 60s);
}

TEST(Disrupter, NearAndInTheMiddleItDisruptsTheHeavyChargeAndTheMissionIsWon) {
  Mission dut = RunMission(AimAtChargeH(kOnTarget) +
                               "expect bomb disrupted\nspeed high\n"
                               "hold M02 until mission success within 30s\n",
                           "bomb_disrupt");
  PlayScript(dut, 200s);
  const sim::StepResult& last = dut.rig().simulator().last();
  EXPECT_EQ(last.disposal.detonation, sim::DetonationCause::kNone);
  const sim::ScoreSheet sheet = dut.rig().simulator().scorer().Sheet();
  EXPECT_TRUE(sheet.passed);
  for (const sim::ScoreItem& item : sheet.parts[1].items) {
    EXPECT_EQ(item.points == 0, item.name != "unseen_driving") << item.name;
  }
}

TEST(Disrupter, OffTheMiddleItSetsTheChargeOff) {
  // 4 degrees up over 0.82 m along the line: 57 mm past the middle, 30 are allowed.
  Mission dut = RunMission(AimAtChargeH(kOnTarget, 4) + "expect bomb exploded\n", "bomb_disrupt");
  PlayScript(dut, 200s);
  EXPECT_EQ(dut.rig().simulator().last().disposal.detonation, sim::DetonationCause::kShot);
}

TEST(Disrupter, PastTheChargeItDoesNothing) {
  // 20 degrees up: 0.28 m above the middle, and the charge ends 0.15 m above it.
  Mission dut = RunMission(AimAtChargeH(kOnTarget, 20) + "expect bomb placed\nexpect mission run\n",
                           "bomb_disrupt");
  PlayScript(dut, 200s);
  const sim::DisposalStatus& disposal = dut.rig().simulator().last().disposal;
  EXPECT_EQ(disposal.detonation, sim::DetonationCause::kNone);
  EXPECT_EQ(disposal.circuit_continuity, 0b110);  // the cartridge of circuit 1 is gone
}

TEST(Disrupter, BeyondThreeMetresItSetsTheChargeOff) {
  // At y = 1, the wrist where it was but only 5.8 degrees down: the line sinks by the 0.40 m from
  // muzzle to middle in 3.94 m.
  Mission dut = RunMission(ToChargeLane(8) + MoveJoint(4, 97.5, "M11", false) +
                               MoveJoint(3, 32.2, "M10", true) + MoveJoint(5, 44.5, "M13", false) +
                               "speed creep\nhold M02 until travel <= -1 within 20s\n" + kFire +
                               "expect bomb exploded\n",
                           "bomb_disrupt");
  PlayScript(dut, 200s);
  EXPECT_EQ(dut.rig().simulator().last().disposal.detonation, sim::DetonationCause::kShot);
}

}  // namespace
}  // namespace eod::lockstep
