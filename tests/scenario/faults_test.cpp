#include <gtest/gtest.h>

#include "tests/scenario/operator_script.h"

namespace eod::lockstep {
namespace {

using namespace std::chrono_literals;
using Kind = sim::FaultSpec::Kind;

sim::Scenario WithFault(const std::string& name, const sim::FaultSpec& fault) {
  sim::Scenario scenario = ShippedScenario(name);
  scenario.faults = {fault};
  return scenario;
}

Mission Play(const std::string& text, const sim::FaultSpec& fault) {
  return Mission(box::ParseScript(text, "test.boxscript"), WithFault("flat_first_drive", fault));
}

TEST(Faults, EmergencyStopInTheFieldLatchesTheBoxAndResetWaitsForItsRelease) {
  Mission dut = Play(PowerUp("flat") +
                         "press M01\nwait robot estop within 10s\nwait lamp estop on within 200ms\n"
                         "expect alarm 128\nrelease all\nreset\nstart\nexpect robot estop\n"
                         "wait 5s\nexpect robot estop\nreset\nstart\nwait robot operate within 3s\n"
                         "hold M01 until speed >= 0.1 within 3s\n",
                     {.kind = Kind::kFieldEstop, .at = 3, .duration = 5});
  PlayScript(dut, 60s);
}

TEST(Faults, RadioLossOfThreeSecondsStopsTheRobotAndWantsResetAndStart) {
  Mission dut = Play(PowerUp("flat") +
                         "speed low\npress M01\nwait lamp link fast within 10s\n"
                         "release all\nwait 4s\nexpect robot fault\n"
                         "reset\nstart\nwait robot operate within 3s\n"
                         "hold M02 until speed < -0.1 within 3s\n",
                     {.kind = Kind::kRadioLoss, .at = 3, .duration = 3});
  double longest_loss = 0, fastest = 0;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    longest_loss = std::max(longest_loss, step.link_lost_s);
    // Rule 2: 100 ms, and a ramp of 200 ms.
    if (step.link_lost_s > 0.304) fastest = std::max(fastest, std::abs(step.speed));
  });
  PlayScript(dut, 60s);
  // The last command came up to 20 ms before the fault, the next one up to 20 ms after it.
  EXPECT_NEAR(longest_loss, 3.0, 0.04);
  EXPECT_EQ(fastest, 0);
}

TEST(Faults, BrokenLampStaysDarkWhileTheBuzzerSounds) {
  Mission dut =
      Play(PowerUp("flat") +
               "speed low\npress M01\nwait alarm 16 within 30s\nwait buzzer on within 2s\n"
               "expect lamp collision off\n",
           {.kind = Kind::kLampBroken, .target = "collision", .at = 0});
  PlayScript(dut, 60s);
}

TEST(Faults, SensorOffsetIsSeenOnTheBox) {
  Mission dut = Play(PowerUp("flat") + "wait 500ms\nexpect joint 3 >= 127\nexpect joint 3 <= 128\n",
                     {.kind = Kind::kSensorOffset, .target = "J3", .amount = 7.5, .at = 0});
  PlayScript(dut, 60s);
  EXPECT_NEAR(dut.rig().simulator().last().state.joint[sim::kBigArm], 120 * std::numbers::pi / 180,
              1e-9);
}

TEST(Faults, SlippingPadsLetTheChargeGoAfterTheTimeOfTheRules) {
  Mission dut(box::LoadScript(kData / "firmware_emu/scripts/bomb_ground.boxscript"),
              WithFault("bomb_ground_m", {.kind = Kind::kGripperSlip, .on_grasp = true}));
  std::optional<TimePoint> held, lost;
  bool slips = false;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    const bool holds = step.disposal.held_body >= 0;
    slips = slips || step.disposal.grasp == sim::GraspState::kSlipping;
    if (holds && !held) held = step.time;
    if (held && !holds && !lost) lost = step.time;
  });
  dut.Run(200s);
  ASSERT_TRUE(lost.has_value());
  EXPECT_TRUE(slips);
  EXPECT_NEAR(ToSeconds(*lost - *held), ShippedData().rules.grasp.slip, 0.02);
}

}  // namespace
}  // namespace eod::lockstep
