// Words to actions, actions to controls.
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "firmware_emu/operator_hands.h"
#include "firmware_emu/panel_action.h"
#include "tests/unit/firmware_emu/box_rig.h"

namespace eod::box {
namespace {

using testing::HasSubstr;

// Controls after the action `line` at time 0.
PanelInputs After(std::string_view line) {
  OperatorHands hands;
  hands.Apply(ParseAction(line), At(seconds(0)));
  return hands.inputs();
}

std::string ErrorOf(std::string_view line) {
  try {
    ParseAction(line);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Action, SetsEveryControl) {
  EXPECT_TRUE(After("press M01 M22").controls.motion[0]);
  EXPECT_TRUE(After("press M01 M22").controls.motion[21]);
  EXPECT_FALSE(After("press M01 M22").controls.motion[1]);
  EXPECT_DOUBLE_EQ(After("stick arm_x -25%").controls.axis[3].value, -0.25);
  EXPECT_EQ(After("key maintenance").controls.key, dbc::KeySwitch::kMaintenance);
  EXPECT_TRUE(After("estop press").estop_pressed);
  EXPECT_TRUE(After("estop_a_fault on").estop_a_fault);
  EXPECT_EQ(After("deadman panic").controls.deadman, dbc::Deadman::kPanic);
  EXPECT_EQ(After("reset").controls.reset, dbc::Button::kPressed);
  EXPECT_EQ(After("start").controls.start, dbc::Button::kPressed);
  EXPECT_EQ(After("mode gripper").controls.mode, dbc::ControlMode::kGripper);
  EXPECT_EQ(After("speed high").controls.speed_range, dbc::SpeedRange::kHigh);
  EXPECT_DOUBLE_EQ(After("speed_limit 30%").controls.speed_limit, 0.3);
  EXPECT_DOUBLE_EQ(After("rate 50%").controls.joint_rate, 0.5);
  EXPECT_EQ(After("select_joint 9").controls.joint_select, 9);
  EXPECT_EQ(After("preset can_drop").controls.preset, 5);
  EXPECT_EQ(After("camera mast").controls.camera, dbc::CameraSelect::kMast);
  EXPECT_EQ(After("zoom in").controls.camera_zoom, 1);
  EXPECT_EQ(After("focus far").controls.camera_focus, 2);
  EXPECT_EQ(After("light both").controls.light, 3);
  EXPECT_TRUE(After("infrared on").controls.infrared);
  EXPECT_TRUE(After("horn on").controls.horn);
  EXPECT_TRUE(After("talk on").controls.push_to_talk);
  EXPECT_TRUE(After("listen on").controls.listen);
  EXPECT_TRUE(After("lamp_test on").controls.lamp_test);
  EXPECT_TRUE(After("acknowledge").controls.buzzer_acknowledge);
  EXPECT_TRUE(After("alarm_reset").controls.alarm_reset);
  EXPECT_EQ(After("menu module indoor").controls.menu_module, dbc::Module::kIndoor);
  EXPECT_EQ(After("menu pause").controls.menu_command, dbc::MenuCommand::kPause);
  EXPECT_EQ(After("menu exercise 15").controls.menu_exercise, 15);
  EXPECT_DOUBLE_EQ(After("brightness 80%").controls.brightness, 0.8);
  EXPECT_EQ(After("arm_key armed").controls.arm_key, dbc::FireContact::kOn);
  EXPECT_EQ(After("fire_left pressed").controls.fire_left, dbc::FireContact::kOn);
  EXPECT_EQ(After("fire_right fault").controls.fire_right, dbc::FireContact::kFault);
  EXPECT_EQ(After("circuit 3").controls.circuit, 3);
  EXPECT_FALSE(After("power off").powered);
}

TEST(Action, ErrorsNameTheWordAndWhatIsAllowed) {
  EXPECT_THAT(ErrorOf("levitate"), HasSubstr("'levitate': allowed: press, release"));
  EXPECT_THAT(ErrorOf(""), HasSubstr("'end of line'"));
  EXPECT_EQ(ErrorOf("key sideways"), "'sideways': allowed: off, standby, operate, maintenance");
  EXPECT_EQ(ErrorOf("key"), "'end of line': allowed: off, standby, operate, maintenance");
  EXPECT_EQ(ErrorOf("press M23"), "'M23': allowed: M01 .. M22");
  EXPECT_EQ(ErrorOf("press M0"), "'M0': allowed: M01 .. M22");
  EXPECT_EQ(ErrorOf("press"), "'end of line': allowed: M01 .. M22");
  EXPECT_EQ(ErrorOf("press M01 fast"), "'fast': allowed: nothing more on this line");
  EXPECT_EQ(ErrorOf("stick drive_z 10%"), "'drive_z': allowed: drive_y, drive_x, arm_y, arm_x");
  EXPECT_EQ(ErrorOf("stick drive_y 101%"), "'101%': allowed: -100%..100%");
  EXPECT_EQ(ErrorOf("stick drive_y 0.5"), "'0.5': allowed: -100%..100%");
  EXPECT_EQ(ErrorOf("rate -1%"), "'-1%': allowed: 0%..100%");
  EXPECT_EQ(ErrorOf("rate nan%"), "'nan%': allowed: 0%..100%");
  EXPECT_EQ(ErrorOf("circuit 4"), "'4': allowed: a whole number 0..3");
  EXPECT_EQ(ErrorOf("menu lunch"), "'lunch': allowed: start, pause, resume, reset, end");
  EXPECT_THAT(ErrorOf("menu"), HasSubstr("module, exercise, start"));
  EXPECT_EQ(ErrorOf("menu exercise 16"), "'16': allowed: a whole number 0..15");
  EXPECT_THAT(ErrorOf("menu module moon"), HasSubstr("'moon': allowed: none, flat"));
}

TEST(Hands, LetGoOfATapAfterItsTime) {
  OperatorHands dut;
  dut.Apply(ParseAction("reset"), At(seconds(1)));
  dut.Apply(ParseAction("menu start"), At(seconds(1)));
  dut.Tick(At(milliseconds(1199)));
  EXPECT_EQ(dut.inputs().controls.reset, dbc::Button::kPressed);
  EXPECT_EQ(dut.inputs().controls.menu_command, dbc::MenuCommand::kStart);
  dut.Tick(At(milliseconds(1200)));
  EXPECT_EQ(dut.inputs().controls.reset, dbc::Button::kReleased);
  EXPECT_EQ(dut.inputs().controls.menu_command, dbc::MenuCommand::kNone);
}

TEST(Hands, ReleaseAllFreesButtonsCentresSticksDropsThePresetAndNothingElse) {
  OperatorHands dut;
  for (const auto* line :
       {"press M01 M05", "stick drive_y 50%", "preset carry", "key operate", "release all"}) {
    dut.Apply(ParseAction(line), At(seconds(0)));
  }
  EXPECT_EQ(dut.inputs().controls.motion, (std::array<bool, dbc::kMotionCount>{}));
  EXPECT_EQ(dut.inputs().controls.axis[0].value, 0);
  EXPECT_EQ(dut.inputs().controls.preset, 0);
  EXPECT_EQ(dut.inputs().controls.key, dbc::KeySwitch::kOperate);
}

TEST(Hands, AKeyThatRepeatsHoldsItsMotionAndOneThatStopsLetsGo) {
  OperatorHands dut;
  dut.HoldMotionUntil(1, At(milliseconds(300)));
  dut.HoldMotionUntil(1, At(milliseconds(500)));
  dut.Tick(At(milliseconds(499)));
  EXPECT_TRUE(dut.inputs().controls.motion[0]);
  dut.Tick(At(milliseconds(500)));
  EXPECT_FALSE(dut.inputs().controls.motion[0]);
}

TEST(Hands, AKeyDoesNotShortenAButtonThatIsHeld) {
  OperatorHands dut;
  dut.Apply(ParseAction("press M01"), At(seconds(0)));
  dut.HoldMotionUntil(1, At(milliseconds(300)));
  dut.Tick(At(seconds(1)));
  EXPECT_TRUE(dut.inputs().controls.motion[0]);
}

TEST(Hands, AKeyDoesNotShortenAPresetOrAFireButtonThatIsHeld) {
  OperatorHands dut;
  for (const auto* line : {"preset carry", "fire_left pressed"}) {
    dut.Apply(ParseAction(line), At(seconds(0)));
  }
  dut.HoldPresetUntil(4, At(milliseconds(300)));
  dut.HoldFireUntil(Control::kFireLeft, At(seconds(1)));
  dut.Tick(At(seconds(2)));
  EXPECT_EQ(dut.inputs().controls.preset, 4);
  EXPECT_EQ(dut.inputs().controls.fire_left, dbc::FireContact::kOn);
}

}  // namespace
}  // namespace eod::box
