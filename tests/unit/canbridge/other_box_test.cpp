// Another maker's box: other identifiers (some of 29 bits), bit places, byte order, scales, labels.
// Two files, the same program, the same behaviour.
#include <gtest/gtest.h>

#include "tests/unit/canbridge/bridge_rig.h"

namespace eod::bridge {
namespace {

/// What operator and robot see of each other at one moment of a session.
struct Moment {
  std::string name;
  BoxCommand command;
  dbc::RobotFeedback shown;
};

std::vector<Moment> Session(BridgeRig& rig) {
  std::vector<Moment> moments;
  const auto note = [&](const std::string& name) {
    rig.Run(milliseconds(60));
    moments.push_back({name, rig.commands.back(), rig.shown});
  };
  rig.panel_frames = true;
  rig.panel.speed_range = dbc::SpeedRange::kHigh;
  rig.panel.light = 2;
  rig.robot.module = 1;
  rig.Report(MissionReport{.state = 2, .steps = 3});
  rig.BringUp();
  note("ready");
  for (int motion = 1; motion <= dbc::kMotionCount; ++motion) {
    rig.Hold(motion);
    note("button " + std::to_string(motion));
    rig.Release(motion);
  }
  rig.panel.axis[0].value = -1;
  rig.panel.axis[3].value = 1;
  note("sticks");
  rig.panel.axis = {};
  rig.Hold(1);
  rig.Hold(2);
  note("conflict");
  rig.Release(2);
  rig.robot.inhibit_mask = 0b1;
  rig.robot.inhibit_reason = dbc::InhibitReason::kCollision;
  rig.robot.limit_flags = 0b100;
  rig.Alarm({{0x10, 0b11}});
  note("collision");
  rig.panel.estop_a = false;
  rig.panel.estop_b = true;
  note("e-stop");
  rig.panel.estop_a = true;
  rig.panel.estop_b = false;
  rig.panel.motion = {};
  note("released");
  rig.panel.reset = dbc::Button::kPressed;
  note("reset");
  rig.panel.reset = dbc::Button::kReleased;
  rig.panel.start = dbc::Button::kPressed;
  note("start");
  rig.Hold(1);
  rig.Run(milliseconds(40));
  rig.box_runs = false;
  rig.Run(milliseconds(200));
  note("link lost");
  rig.Run(milliseconds(400));
  note("link latched");
  return moments;
}

TEST(OtherBox, BehavesTheSameWithNothingBuiltAnew) {
  BridgeRig shipped;
  BridgeRig shuffled(EOD_DATA_DIR "/tests/unit/dbc/data/shuffled_box.dbc",
                     EOD_DATA_DIR "/tests/unit/dbc/data/shuffled_box.map.toml");
  const std::vector<Moment> expected = Session(shipped);
  const std::vector<Moment> moments = Session(shuffled);
  ASSERT_EQ(moments.size(), expected.size());
  for (std::size_t i = 0; i < moments.size(); ++i) {
    SCOPED_TRACE(expected[i].name);
    const Moment& a = expected[i];
    const Moment& b = moments[i];
    EXPECT_EQ(b.command, a.command);
    EXPECT_EQ(b.shown.state, a.shown.state);
    EXPECT_EQ(b.shown.module, a.shown.module);
    EXPECT_EQ(b.shown.mission_state, a.shown.mission_state);
    EXPECT_EQ(b.shown.inhibit_mask, a.shown.inhibit_mask);
    EXPECT_EQ(b.shown.inhibit_reason, a.shown.inhibit_reason);
    EXPECT_EQ(b.shown.lamp, a.shown.lamp);
    EXPECT_EQ(b.shown.buzzer, a.shown.buzzer);
    EXPECT_EQ(b.shown.hit_parts, a.shown.hit_parts);
    EXPECT_EQ(b.shown.alarm_code, a.shown.alarm_code);
  }
  // The session itself went where it was meant to go.
  EXPECT_EQ(expected[1].command.motion_rate[0], 1.0);
  EXPECT_EQ(expected.back().command.system_state, dbc::SystemState::kFault);
}

TEST(OtherBox, ReallyHasOtherBits) {
  BridgeRig shipped;
  BridgeRig shuffled(EOD_DATA_DIR "/tests/unit/dbc/data/shuffled_box.dbc",
                     EOD_DATA_DIR "/tests/unit/dbc/data/shuffled_box.map.toml");
  shipped.Hold(1);
  shuffled.Hold(1);
  for (const auto role : {dbc::BoxMessage::kSafety, dbc::BoxMessage::kMotion}) {
    EXPECT_FALSE(SameOnWire(*shipped.box.Encode(role, shipped.panel),
                            *shuffled.box.Encode(role, shuffled.panel)));
  }
}

}  // namespace
}  // namespace eod::bridge
