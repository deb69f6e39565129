// What the robot stopped for by itself, and the way back.
#include <gtest/gtest.h>

#include "tests/unit/canbridge/bridge_rig.h"
#include "tests/unit/canbridge/supervision_rig.h"

namespace eod::bridge {
namespace {

using dbc::SystemState;

TEST(RobotStops, SilenceThatTheRobotLatchedForLatchesHereAndCountsTheReset) {
  SupervisionRig rig;
  rig.DriveForward();
  rig.dut.NoteRobotStops(rig.now, {.link = true});
  EXPECT_TRUE(rig.IsAtRest());
  EXPECT_EQ(rig.outcome().state, SystemState::kFault);
  EXPECT_EQ(rig.outcome().refusal, Refusal::kRobotLinkLatched);
  EXPECT_TRUE(rig.outcome().link_alarm);
  rig.Release(1);
  rig.Run(milliseconds(100));
  EXPECT_EQ(rig.outcome().resets, 0);
  rig.PressReset();
  EXPECT_EQ(rig.outcome().resets, 1);
  // The robot hears of it late, and goes on saying that it is latched until then.
  rig.dut.NoteRobotStops(rig.now, {.link = true});
  rig.PressStart();
  rig.dut.NoteRobotStops(rig.now, {.link = false});
  EXPECT_TRUE(rig.is_permitted());
  rig.dut.NoteRobotStops(rig.now, {.link = true});
  EXPECT_FALSE(rig.is_permitted()) << "a new silence";
}

TEST(RobotStops, EmergencyStopOnTheRobotCannotBeResetWhileItIsPressed) {
  SupervisionRig rig;
  rig.DriveForward();
  rig.dut.NoteRobotStops(rig.now, {.estop = true});
  EXPECT_TRUE(rig.IsAtRest());
  EXPECT_EQ(rig.outcome().state, SystemState::kEstopLatched);
  EXPECT_EQ(rig.outcome().reason, dbc::InhibitReason::kEstop);
  EXPECT_TRUE(rig.outcome().estop_alarm);
  rig.Release(1);
  rig.Run(milliseconds(100));
  rig.PressReset();
  EXPECT_EQ(rig.outcome().state, SystemState::kEstopLatched);
  rig.dut.NoteRobotStops(rig.now, {});
  EXPECT_EQ(rig.outcome().state, SystemState::kEstopLatched) << "released alone is no Reset";
  rig.PressReset();
  rig.PressStart();
  EXPECT_TRUE(rig.is_permitted());
}

TEST(RobotStops, BrokenLampStaysDarkAndTheBuzzerSounds) {
  BridgeRig rig;
  rig.Run(milliseconds(120));
  RobotReport report;
  report.dark_lamps = 1U << static_cast<unsigned>(dbc::Lamp::kCollision);
  rig.Report(report);
  rig.Alarm({{0x10, 1}});
  rig.Run(milliseconds(20));
  EXPECT_EQ(rig.lamp(dbc::Lamp::kCollision), dbc::LampPattern::kOff);
  EXPECT_NE(rig.shown.buzzer, dbc::BuzzerPattern::kOff);
  rig.Report(RobotReport{});
  rig.Run(milliseconds(60));
  EXPECT_EQ(rig.lamp(dbc::Lamp::kCollision), dbc::LampPattern::kFastBlink);
}

TEST(RobotStops, BoxIsShownTheWorseOfTheTwoLinks) {
  BridgeRig rig;
  rig.Run(milliseconds(1500));
  ASSERT_NEAR(rig.shown.link_quality, 1, 0.02);
  RobotReport report;
  report.link_quality = 0.4;
  rig.Report(report);
  rig.Run(milliseconds(100));
  EXPECT_NEAR(rig.shown.link_quality, 0.4, 0.005);
}

}  // namespace
}  // namespace eod::bridge
