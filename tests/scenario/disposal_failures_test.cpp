// Each way to lose a charge, through the box.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/scenario/charge_script.h"

namespace eod::lockstep {
namespace {

using namespace std::chrono_literals;

sim::DetonationCause CauseOf(Mission& mission) {
  return mission.rig().simulator().last().disposal.detonation;
}

TEST(LostCharge, DroppedOnTheGroundItGoesOffAndDoesSoToTheSameBitsTwice) {
  const std::string script = TakeChargeM() +
                             "hold M17 for 1s\nwait bomb exploded within 3s\n"
                             "wait mission fail within 1s\nexpect failure exploded\n";
  Mission dut = RunMission(script, "bomb_ground_m");
  Mission again = RunMission(script, "bomb_ground_m");
  PlayScript(dut, 120s);
  PlayScript(again, 120s);
  EXPECT_EQ(CauseOf(dut), sim::DetonationCause::kDropped);
  EXPECT_TRUE(dut.rig().simulator().last().disposal.robot_destroyed);
  EXPECT_TRUE(dut.can_log() == again.can_log());
  EXPECT_TRUE(dut.states() == again.states());
}

TEST(LostCharge, PushedOnAfterTheAlarmItTopplesAndGoesOff) {
  // The closed hand high on the charge, straight into it.
  Mission dut = RunMission(PowerUp("bomb") +
                               "speed low\nhold preset ground_pick until joint 4 >= 108.6 within "
                               "20s\nhold M09 for 1s\nwait 500ms\nhold M01 until travel >= 4.3 "
                               "within 30s\nspeed creep\npress M01\nwait bomb touched within 15s\n"
                               "wait alarm any within 1s\nwait bomb exploded within 30s\n"
                               "expect failure exploded\n",
                           "bomb_ground_m");
  PlayScript(dut, 120s);
  EXPECT_EQ(CauseOf(dut), sim::DetonationCause::kTipped);
}

TEST(LostCharge, PushedOverTheTablesEdgeItGoesOffBeyondIt) {
  // Between two finger tips that stand closer than it is thick, the hand pitched up by 2 degrees,
  // 1.15 m ahead and 0.80 m high: their lower edges push 30 mm above its foot. It slides, for it
  // would tip from its radius over its friction on, 30 mm / 0.6.
  Mission dut = RunMission(ToChargeLane(-4) + MoveJoint(3, 51.4, "M10", true) +
                               MoveJoint(4, 96.7, "M11", false) + MoveJoint(5, 33.9, "M13", false) +
                               Open(0.01) + DriveAhead(2.4) +
                               "speed creep\npress M01\nwait bomb touched within 15s\n"
                               "wait bomb exploded within 15s\n",
                           "bomb_table_s");
  double y_before = 0;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    if (step.disposal.detonation == sim::DetonationCause::kNone) y_before = step.charge.y();
  });
  PlayScript(dut, 120s);
  const double far_edge = 6.07 + 0.70 / 2;
  EXPECT_GT(y_before, far_edge - 0.030);  // its radius
  EXPECT_TRUE(CauseOf(dut) == sim::DetonationCause::kTipped ||
              CauseOf(dut) == sim::DetonationCause::kDropped);
}

TEST(LostCharge, SqueezedOffItsMiddleItGoesOff) {
  // 38 mm short of the middle: the five lines never agree.
  Mission dut = RunMission(
      AroundChargeM(0.2) + "press M18\nwait bomb exploded within 8s\nexpect failure exploded\n",
      "bomb_ground_m");
  PlayScript(dut, 120s);
  EXPECT_EQ(CauseOf(dut), sim::DetonationCause::kSqueezed);
}

TEST(LostCharge, CarriedIntoTheRimItGoesOff) {
  Mission dut = RunMission(TakeChargeM() +
                               "hold preset carry until joint 3 >= 70.0 within 20s\nspeed low\n"
                               "press M01\nwait bomb exploded within 60s\n",
                           "bomb_ground_m");
  PlayScript(dut, 200s);
  EXPECT_EQ(CauseOf(dut), sim::DetonationCause::kRimStrike);
}

/// Charge H between the hands, near enough to bear its 12 kg: the hand's middle 0.95 m ahead and
/// 0.15 m high, pitched down by 30 degrees.
std::string TakeChargeH() {
  return ToChargeLane(8) + MoveJoint(4, 79.4, "M11", false) + MoveJoint(3, 26.9, "M10", true) +
         MoveJoint(5, 43.8, "M13", false) + Open(0.1) + DriveAhead(3.05) +
         "wait 500ms\nhold M18 until grasp grasped within 8s\nwait 500ms\n";
}

TEST(HeavyCharge, IsCarriedOutAsFarAsTheArmBearsItAndTheBoxSaysWhy) {
  Mission dut = RunMission(TakeChargeH() +
                               "hold M09 for 2s\nwait 300ms\npress M11\nwait reason payload within "
                               "10s\nexpect inhibit M11\n"
                               "release all\nwait 500ms\nexpect reason none\n"
                               "expect grasp grasped\nhold M12 for 500ms\nwait 300ms\n"
                               "expect grasp grasped\n",
                           "bomb_disrupt");
  std::optional<double> reach;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    if (step.inhibit_reason != sim::kReasonPayload || reach) return;
    const auto& joint = step.state.joint;
    const double big = joint[sim::kBigArm], small = big + joint[sim::kSmallArm] - M_PI;
    // Big arm, small arm, and the crossbeam, which goes back by two thirds of the opening (Eq. 6).
    reach = 0.75 * std::cos(big) + 0.65 * std::cos(small) +
            (0.15 - joint[sim::kGripperOpening] * 2 / 3) * std::cos(small + joint[sim::kWrist]);
  });
  PlayScript(dut, 200s);
  ASSERT_TRUE(reach.has_value());
  // 8 kg at full stretch, the same moment for 12 kg; a step of the small arm is 0.7 mm at 0.7 m.
  EXPECT_NEAR(*reach, 8 * (0.75 + 0.65 + 0.15) / 12, 0.001);
}

TEST(HeavyCharge, SlipsOutWhenTheRobotLeansForItAndGoesOff) {
  // At the limit of the payload, the hand still lower than the shoulder; then the front is lifted
  // by its own flippers, and the reach grows.
  Mission dut = RunMission(TakeChargeH() +
                               "hold M09 for 1200ms\nwait 300ms\npress M11\nwait reason payload "
                               "within 10s\nrelease all\n"
                               "wait 500ms\nhold M06 until grasp slipping within 10s\n"
                               "wait grasp released within 4s\nwait bomb exploded within 2s\n",
                           "bomb_disrupt");
  std::optional<TimePoint> slips, falls;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    if (step.disposal.grasp == sim::GraspState::kSlipping && !slips) slips = step.time;
    if (step.disposal.grasp == sim::GraspState::kReleased && !falls) falls = step.time;
  });
  PlayScript(dut, 200s);
  ASSERT_TRUE(slips && falls);
  EXPECT_NEAR(ToSeconds(*falls - *slips), ShippedData().rules.grasp.slip, 0.01);
  EXPECT_EQ(CauseOf(dut), sim::DetonationCause::kDropped);
}

TEST(HeavyCharge, IsNotGraspedFartherOutThanItCanBeBorne) {
  // Hand in the middle of the charge, 1.20 m ahead: the arm bears 10 kg there.
  Mission dut =
      RunMission(ToChargeLane(8) + "hold preset ground_pick until joint 4 >= 108.6 within 20s\n" +
                     Open(0.1) + DriveAhead(2.8) +
                     "press M18\nwait grasp contact_both within 5s\nwait 500ms\n"
                     "expect not grasp grasped\nwait bomb exploded within 2s\n",
                 "bomb_disrupt");
  PlayScript(dut, 200s);
  EXPECT_EQ(CauseOf(dut), sim::DetonationCause::kSqueezed);
}

}  // namespace
}  // namespace eod::lockstep
