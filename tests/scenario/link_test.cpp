#include <cmath>

#include <gtest/gtest.h>

#include "tests/scenario/operator_script.h"

namespace eod::lockstep {
namespace {

using namespace std::chrono_literals;
using Kind = sim::ControlLinkSpec::Kind;

/// Flat module, base 4 m behind the start: the robot leaves the range of 7 m before the wall.
sim::Scenario ShortRadio() {
  sim::Scenario scenario = ShippedScenario("flat_first_drive");
  scenario.link = {.kind = Kind::kRadio, .base = Eigen::Vector2d(0, -4), .range = 7};
  return scenario;
}

/// Where on the way north the quality is `quality` [m].
double NorthingOf(double quality) {
  const sim::LinkRules& rules = ShippedData().rules.link;
  const double distance = 7 * (1 - quality), height = rules.base_antenna - rules.robot_antenna;
  return std::sqrt(distance * distance - height * height) - 4;
}

TEST(RadioLink, DrivesAwayUntilItStopsByItselfAndComesBackInShortHolds) {
  std::string text = PowerUp("flat") +
                     "speed low\npress M01\nwait reason neutral_needed within 30s\n"
                     "release all\nwait 500ms\n";
  for (int i = 0; i < 30; ++i) text += "hold M02 for 300ms\nwait 300ms\n";
  Mission dut(box::ParseScript(text, "test.boxscript"), ShortRadio());
  double farthest = 0, longest_loss = 0;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    farthest = std::max(farthest, step.state.position.y());
    longest_loss = std::max(longest_loss, step.link_lost_s);
  });
  ASSERT_TRUE(dut.Run(120s));
  EXPECT_EQ(dut.box().script_failure(), std::nullopt);
  // It stopped where messages get lost, and before all do.
  EXPECT_GT(farthest, NorthingOf(ShippedData().rules.link.drop_below));
  EXPECT_LT(farthest, NorthingOf(0));
  EXPECT_GT(longest_loss, 0.1);
  // Back where nothing gets lost.
  const sim::StepResult& last = dut.rig().simulator().last();
  EXPECT_GT(last.link_quality, ShippedData().rules.link.drop_below);
  EXPECT_EQ(last.contact_parts, 0u);
}

TEST(RadioLink, BoxShowsTheQualityOfTheLink) {
  Mission dut(box::ParseScript(PowerUp("flat") + "wait 1s\n", "test.boxscript"), ShortRadio());
  PlayScript(dut, 30s);
  const double quality = dut.rig().simulator().last().link_quality;
  EXPECT_NEAR(quality, 1 - std::hypot(4, 0.8) / 7, 1e-6);
  EXPECT_NEAR(dut.box().status().feedback.link_quality, quality, 0.005);  // in whole percent
}

TEST(RadioLink, DelaysOfBothWaysAddUpOnTheBox) {
  sim::Scenario scenario = ShippedScenario("flat_first_drive");
  scenario.link.commands.delay = 0.2;
  scenario.link.telemetry.delay = 0.3;
  const std::string text = PowerUp("flat") + "speed low\npress M01\nwait speed >= 0.1 within 5s\n";
  const auto played = [&](const sim::Scenario& each) {
    Mission dut(box::ParseScript(text, "test.boxscript"), each);
    std::optional<TimePoint> asked;
    while (!dut.box().is_script_done() && dut.rig().now() < TimePoint{60s}) {
      dut.Tick();
      if (!asked && dut.rig().bridge().bridge().supervision().rate[0] > 0) asked = dut.rig().now();
    }
    EXPECT_EQ(dut.box().script_failure(), std::nullopt);
    return dut.rig().now() - asked.value();
  };
  const Duration direct = played(ShippedScenario("flat_first_drive"));
  // The box sees poses every 50 ms: the phase of those may take as much away.
  EXPECT_NEAR(ToSeconds(played(scenario) - direct), 0.5, 0.05);
}

TEST(RadioLink, TwoLossyRunsGiveTheSameBits) {
  sim::Scenario scenario = ShortRadio();
  scenario.link.commands = {.delay = 0.1, .jitter = 0.1, .loss = 0.05};
  scenario.link.telemetry = scenario.link.commands;
  const std::string text = PowerUp("flat") + "hold M01 for 6s\nhold M03 for 2s\nwait 1s\n";
  const auto states = [&] {
    Mission dut(box::ParseScript(text, "test.boxscript"), scenario);
    EXPECT_TRUE(dut.Run(60s));
    return dut.states() + dut.can_log();
  };
  EXPECT_TRUE(states() == states());
}

TEST(RadioLink, EmergencyStopOverALateLinkStopsTheRobotByTheDelayAndOneStep) {
  sim::Scenario scenario = ShippedScenario("flat_first_drive");
  scenario.link.commands.delay = 0.2;
  Mission dut(box::ParseScript(PowerUp("flat") + "speed low\npress M01\nwait 2s\nestop press\n",
                               "test.boxscript"),
              scenario);
  std::optional<TimePoint> latched, stopped;
  double before = 0;
  while (!stopped && dut.rig().now() < TimePoint{60s}) {
    dut.Tick();
    const bool is_latched =
        dut.rig().bridge().bridge().supervision().state == dbc::SystemState::kEstopLatched;
    if (is_latched && !latched) latched = dut.rig().now();
    const double speed = dut.rig().simulator().last().speed;
    if (latched && speed == 0) stopped = dut.rig().now();
    if (speed > 0) before = speed;
  }
  ASSERT_TRUE(stopped.has_value());
  EXPECT_NEAR(before, 0.30, 1e-9);
  EXPECT_GE(*stopped - *latched, 200ms);
  EXPECT_LE(*stopped - *latched, 200ms + 4ms);
}

}  // namespace
}  // namespace eod::lockstep
