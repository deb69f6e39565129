// Box to robot: frames in, commands out.
#include <string>

#include <gtest/gtest.h>

#include "platform/candump_log.h"
#include "tests/unit/canbridge/bridge_rig.h"

namespace eod::bridge {
namespace {

using dbc::BoxMessage;
using dbc::SystemState;

// `ID#DATA` as cansend takes it.
CanFrame Frame(const std::string& text) {
  return ParseCandumpLine("(0.000000) vcan0 " + text).value();
}

TEST(BridgeCommands, GoldenFramesOfTheBoxDriveForwardAndStop) {
  BridgeRig rig;
  rig.box_runs = false;
  rig.Run(milliseconds(10));
  // The example frames of the box's specification: operate, enabled, drive, low range, 100 %, 24 V,
  // counter 0; all buttons released, counter 14.
  rig.Take(Frame("710#05"));
  rig.Take(Frame("190#98200511C8007810"));
  rig.Take(Frame("290#510E000000000000"));
  rig.Run(milliseconds(20));
  // The same safety frame with counter 1; forward, rate 100 %, counter 0.
  rig.Take(Frame("190#C5210511C8007810"));
  rig.Take(Frame("290#6F0001000000C800"));
  const BoxCommand& command = rig.commands.back();
  EXPECT_TRUE(command.motion_permitted);
  EXPECT_EQ(command.system_state, SystemState::kOperate);
  MotionRates forward{};
  forward[0] = 1;
  EXPECT_EQ(command.motion_rate, forward);
  EXPECT_EQ(command.speed_range, dbc::SpeedRange::kLow);
  EXPECT_EQ(command.control_mode, dbc::ControlMode::kDrive);
  // Emergency stop pressed, enabling switch released, counter 2.
  rig.Take(Frame("190#ED220211C8007810"));
  EXPECT_EQ(rig.commands.back().system_state, SystemState::kEstopLatched);
  EXPECT_EQ(rig.commands.back().motion_rate, MotionRates{});
}

TEST(BridgeCommands, GoldenAxesFrameDrivesByStick) {
  BridgeRig rig;
  rig.panel.deadman = dbc::Deadman::kEnabled;
  rig.SendFromBox(BoxMessage::kHeartbeat);
  rig.Run(milliseconds(60));                // sticks at rest: counters 0, 1, 2
  rig.Take(Frame("390#DB03F461F0000000"));  // drive Y +50 %, X -25 %, counter 3
  // Stretched beyond the dead zone of 5 %: (0.50 - 0.05) / 0.95 and (0.25 - 0.05) / 0.95.
  const MotionRates& rate = rig.commands.back().motion_rate;
  EXPECT_NEAR(rate[0], 0.45 / 0.95, 1e-9) << "M01 forward";
  EXPECT_NEAR(rate[2], 0.20 / 0.95, 1e-9) << "M03 turn left";
}

TEST(BridgeCommands, FrameThatChangesTheCommandIsTranslatedAtOnce) {
  BridgeRig rig;
  rig.BringUp();
  rig.Run(milliseconds(7));
  rig.Forget();
  rig.Hold(1);
  rig.SendFromBox(BoxMessage::kMotion);
  ASSERT_EQ(rig.commands.size(), 1U) << "in the call that took the frame";
  EXPECT_EQ(rig.forward(), 1.0);
}

TEST(BridgeCommands, FrameThatChangesNothingIsNotPublished) {
  BridgeRig rig;
  rig.BringUp();
  rig.Hold(1);
  rig.SendFromBox(BoxMessage::kMotion);
  rig.Forget();
  rig.SendFromBox(BoxMessage::kMotion);
  rig.SendFromBox(BoxMessage::kSafety);
  EXPECT_TRUE(rig.commands.empty());
}

TEST(BridgeCommands, CommandIsRepeatedEvery20Milliseconds) {
  BridgeRig rig;
  rig.BringUp();
  rig.Run(milliseconds(20));
  rig.Forget();
  rig.Run(milliseconds(1000));
  EXPECT_EQ(rig.commands.size(), 50U);
}

TEST(BridgeCommands, CommandComesFromTheStartEvenWithoutABox) {
  BridgeRig rig;
  rig.box_runs = false;
  rig.Run(milliseconds(1));
  ASSERT_EQ(rig.commands.size(), 1U);
  EXPECT_EQ(rig.commands[0].system_state, SystemState::kStandby);
  EXPECT_FALSE(rig.commands[0].motion_permitted);
}

TEST(BridgeCommands, RampIsPublishedStepByStep) {
  BridgeRig rig;
  rig.BringUp();
  rig.Hold(1);
  rig.Run(milliseconds(40));  // 340 ms, frames just sent
  rig.box_runs = false;
  rig.Run(milliseconds(100));
  rig.Forget();
  rig.Run(milliseconds(200));
  EXPECT_EQ(rig.commands.size(), 200U) << "one each millisecond";
  EXPECT_EQ(rig.forward(), 0.0);
}

TEST(BridgeCommands, SpeedLimitScales) {
  BridgeRig rig;
  rig.panel.speed_limit = 0.5;
  rig.BringUp();
  rig.Hold(1);
  rig.Run(milliseconds(20));
  EXPECT_DOUBLE_EQ(rig.forward(), 0.5);
}

TEST(BridgeCommands, PanelControlsPassWithoutTheEnablingSwitch) {
  BridgeRig rig;
  rig.panel.menu_module = dbc::Module::kFlat;
  rig.panel.menu_exercise = 3;
  rig.panel.menu_command = dbc::MenuCommand::kStart;
  rig.panel.camera = dbc::CameraSelect::kMast;
  rig.panel.light = 3;
  rig.panel.horn = true;
  rig.panel_frames = true;
  rig.Run(milliseconds(100));
  const BoxCommand& command = rig.commands.back();
  EXPECT_FALSE(command.motion_permitted);
  EXPECT_EQ(command.menu_module, dbc::Module::kFlat);
  EXPECT_EQ(command.menu_exercise, 3);
  EXPECT_EQ(command.menu_command, dbc::MenuCommand::kStart);
  EXPECT_EQ(command.camera_select, dbc::CameraSelect::kMast);
  EXPECT_EQ(command.light, 3);
  EXPECT_TRUE(command.horn);
}

TEST(BridgeCommands, MomentaryControlsAreReleasedWhenThePanelFallsSilent) {
  BridgeRig rig;
  rig.panel.menu_command = dbc::MenuCommand::kStart;
  rig.panel.horn = true;
  rig.panel.light = 1;
  rig.panel_frames = true;
  rig.Run(milliseconds(100));
  rig.panel_frames = false;
  rig.Run(milliseconds(500));
  EXPECT_TRUE(rig.commands.back().horn);
  rig.Run(milliseconds(1));
  EXPECT_FALSE(rig.commands.back().horn);
  EXPECT_EQ(rig.commands.back().menu_command, dbc::MenuCommand::kNone);
  EXPECT_EQ(rig.commands.back().light, 1) << "a switch stays as it was";
}

TEST(BridgeCommands, PresetPassesOnlyWhileMotionIsPermitted) {
  BridgeRig rig;
  rig.BringUp();
  rig.panel.preset = 1;
  rig.Run(milliseconds(20));
  EXPECT_EQ(rig.commands.back().preset, 1);
  rig.panel.deadman = dbc::Deadman::kReleased;
  rig.Run(milliseconds(20));
  EXPECT_EQ(rig.commands.back().preset, 0);
  rig.panel.deadman = dbc::Deadman::kEnabled;
  rig.Run(milliseconds(40));
  EXPECT_EQ(rig.commands.back().preset, 0) << "held through the stop: not neutral";
}

}  // namespace
}  // namespace eod::bridge
