#include <cmath>

#include <gtest/gtest.h>

#include "sim/geometry/gravity.h"
#include "tests/scenario/terrain_lanes.h"

namespace eod::lockstep {
namespace {

using namespace std::chrono_literals;

/// Up the ramp of 10 degrees and off the right side of its platform, 0.52 m high.
std::string OffTheSide() {
  return ToLane(4) +
         "speed low\nhold M01 until travel >= 3 within 60s\nhold M04 until heading <= 340 within "
         "5s\n"
         "hold M01 until mission fail within 30s\nwait failure rollover within 1s\nexpect lamp "
         "tilt on\n"
         "expect alarm 49\nwait 3s\n";
}

TEST(Rollover, OffTheSideOfARampFailsTheMissionAndEndsTheDrive) {
  Mission dut =
      RunMission(OffTheSide() +
                     "note \"down\"\npress M02\nwait reason tilt within 1s\nexpect inhibit M02\n"
                     "wait 2s\nrelease all\nwait 100ms\npress M01\nwait reason tilt within 1s\n"
                     "expect inhibit M01\nwait 2s\nrelease all\nexpect alarm 49\n",
                 "slope_ramps");
  sim::RobotState lies;
  int64_t since = 0;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    if (step.state == lies) return;
    lies = step.state;
    since = step.step;
  });
  PlayScript(dut, 200s);
  const sim::StepResult& last = dut.rig().simulator().last();
  EXPECT_GE((last.step - since) * 4ms, 4s);
  EXPECT_TRUE(lies.rolls_over);
  EXPECT_GE(std::acos(std::cos(lies.attitude.pitch) * std::cos(lies.attitude.roll)),
            ShippedData().robot.stance.overturned);
  // The side of the ramp is 1.2 m from the middle of its lane.
  EXPECT_NEAR(lies.position.x(), 4 + 1.2, 0.15);
  EXPECT_GT(lies.attitude.roll, 0);
}

TEST(Rollover, TwoRunsGiveTheSameBits) {
  Mission first = RunMission(OffTheSide(), "slope_ramps");
  Mission second = RunMission(OffTheSide(), "slope_ramps");
  PlayScript(first, 200s);
  PlayScript(second, 200s);
  EXPECT_TRUE(first.can_log() == second.can_log());
  EXPECT_TRUE(first.states() == second.states());
}

TEST(FreeFall, OffAPlatformIsReportedAndEndsOnTheGround) {
  const double height = 3 * std::sin(20 * kDegree);
  Mission dut =
      RunMission(ToLane(12) + "speed low\nhold M01 until travel >= 5.5 within 60s\nwait 500ms\n" +
                     TurnTo(270, false) +
                     "speed high\nhold M01 until lamp tilt on within 5s\n"
                     "wait mission fail within 1s\nwait failure rollover within 1s\nwait 3s\n"
                     "expect speed <= 0\n",
                 "slope_ramps");
  double fastest = 0, sank = 0, was_at = 0;
  int jumps = 0;
  dut.rig().SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    // Nothing gathers speed faster than gravity makes it, and the drive adds its own.
    const double most = sank + sim::kGravity * 0.004 + 1e-9;
    const sim::RobotState& state = step.state;
    jumps += state.fall_speed > most ||
             was_at - state.position.z() > (most + std::abs(step.speed)) * 0.004;
    sank = state.fall_speed;
    fastest = std::max(fastest, (was_at - state.position.z()) / 0.004 - std::abs(step.speed));
    was_at = state.position.z();
  });
  PlayScript(dut, 300s);
  EXPECT_EQ(jumps, 0);
  // No more than by a fall through all the height, and more than through a fourth of it.
  EXPECT_LT(fastest, std::sqrt(2 * sim::kGravity * height));
  EXPECT_GT(fastest, std::sqrt(sim::kGravity * height / 2));
  const sim::RobotState& end = dut.rig().simulator().last().state;
  EXPECT_TRUE(end.at_rest);
  EXPECT_NEAR(end.position.z(), 0, 1e-3);
  EXPECT_GT(end.position.x(), 12 + 1.2);
}

}  // namespace
}  // namespace eod::lockstep
