// Drives through the two-storey office of the indoor module.
#include <cmath>

#include "tests/scenario/operator_script.h"

namespace eod::lockstep {
namespace {

using namespace std::chrono_literals;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kRise = 0.165, kRun = 0.280;
constexpr int kSteps = 9;
constexpr double kLanding = kSteps * kRise, kSecondFloor = 2 * kSteps * kRise;  // [m]

// Bits of the parts in contact: flippers pressed on the ground, pads on the charge.
constexpr uint32_t kSmallWheels = 0x0F, kHands = 0x30;

/// What the way up and down came to.
struct Climb {
  double highest = 0;       ///< [m] at rest on level ground
  double steepest = 0;      ///< [rad] pitch
  double lean = 0;          ///< [rad] roll
  uint32_t touched = 0;     ///< anything, by these parts
  bool on_landing = false;  ///< stood level there
  void Watch(LockStepRig& rig) {
    rig.SetStepSink([this](const sim::StepResult& step, const sim::AlarmTable&) {
      const auto& [pitch, roll] = std::pair(step.state.attitude.pitch, step.state.attitude.roll);
      steepest = std::max(steepest, pitch);
      lean = std::max(lean, std::abs(roll));
      touched |= step.contact_parts;
      if (std::abs(pitch) > 1e-6 || !step.state.at_rest) return;
      highest = std::max(highest, step.state.position.z());
      on_landing |= std::abs(step.state.position.z() - kLanding) < 1e-6;
    });
  }
};

TEST(Office, StairsAreDrivenUpTurnedOnAndDrivenDownTouchedByFlippersAlone) {
  Mission dut(box::LoadScript(kData / "firmware_emu/scripts/indoor_stairs.boxscript"),
              ShippedScenario("indoor_stairs"));
  Climb seen;
  seen.Watch(dut.rig());
  PlayScript(dut, 600s);
  const sim::StepResult& last = dut.rig().simulator().last();
  EXPECT_EQ(last.task.state, sim::MissionState::kSuccess);
  EXPECT_EQ(seen.touched & ~kSmallWheels, 0u);
  EXPECT_TRUE(seen.on_landing);
  EXPECT_NEAR(seen.highest, kSecondFloor, 1e-6);
  EXPECT_LT(seen.steepest, std::atan2(kRise, kRun) + 3 * kDegree);
  EXPECT_LT(seen.lean, 0.5 * kDegree);
  EXPECT_NEAR(last.state.position.z(), 0, 1e-6);
}

TEST(Office, ChargeIsTakenFromUnderTheDeskOnTheSecondFloor) {
  Mission dut(box::LoadScript(kData / "firmware_emu/scripts/indoor_charge.boxscript"),
              ShippedScenario("indoor_stairs"));
  uint32_t touched = 0;
  dut.rig().SetStepSink(
      [&](const sim::StepResult& step, const sim::AlarmTable&) { touched |= step.contact_parts; });
  PlayScript(dut, 600s);
  const sim::StepResult& last = dut.rig().simulator().last();
  EXPECT_EQ(touched & ~(kSmallWheels | kHands), 0u);
  EXPECT_NEAR(last.state.position.z(), kSecondFloor, 1e-6);
  EXPECT_NE(last.task.state, sim::MissionState::kFail);
}

TEST(Office, HalfOpenDoorStopsTheRobotInItsFrame) {
  Mission dut = RunMission(
      PowerUp("indoor") + DriveAhead(11.2) + "expect lamp collision off\n" +
          "hold M03 until lamp collision on within 15s\nwait 500ms\nexpect reason collision\n",
      "indoor_stairs");
  PlayScript(dut, 120s);
  // Along x = 0 the wall behind it is too near to turn to the west.
  EXPECT_LT(dut.rig().simulator().last().state.attitude.heading, 60 * kDegree);
}

TEST(Office, ServerAisleIsEnteredByATurnInTheCorridor) {
  Mission dut = RunMission(PowerUp("indoor") + DriveAhead(10.8) + TurnTo(270, false) +
                               DriveAhead(4.5) + "expect collisions < 1\n",
                           "indoor_stairs");
  PlayScript(dut, 120s);
  EXPECT_NEAR(dut.rig().simulator().last().state.position.x(), 4.5, 0.05);
}

}  // namespace
}  // namespace eod::lockstep
