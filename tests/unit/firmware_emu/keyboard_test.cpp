// Terminal bytes to keys, keys to controls.
#include "firmware_emu/keyboard.h"

#include <gtest/gtest.h>

#include "tests/unit/firmware_emu/box_rig.h"

namespace eod::box {
namespace {

using Kind = Key::Kind;

Key Character(char character) { return {.kind = Kind::kCharacter, .character = character}; }

TEST(KeyParser, ReadsCharactersEnterAndArrows) {
  KeyParser dut;
  EXPECT_EQ(dut.Feed("a \r\x1b[A\x1b[B\x1bOC\x1b[D"), (std::vector<Key>{Character('a'),
                                                                        Character(' '),
                                                                        {Kind::kEnter},
                                                                        {Kind::kUp},
                                                                        {Kind::kDown},
                                                                        {Kind::kRight},
                                                                        {Kind::kLeft}}));
}

TEST(KeyParser, PutsASequenceInPiecesTogether) {
  KeyParser dut;
  EXPECT_TRUE(dut.Feed("\x1b").empty());
  EXPECT_TRUE(dut.Feed("[").empty());
  EXPECT_EQ(dut.Feed("A"), std::vector<Key>{{Kind::kUp}});
}

TEST(KeyParser, ReadsArrowsWithModifiers) {
  EXPECT_EQ(KeyParser().Feed("\x1b[1;5A"), std::vector<Key>{{Kind::kUp}});
}

TEST(KeyParser, SwallowsOtherSequences) {
  EXPECT_EQ(KeyParser().Feed("\x1b[3~\x1b[15~\x1bOPx"), std::vector<Key>{Character('x')});
}

TEST(KeyParser, IgnoresControlBytesAndBytesBeyondAscii) {
  EXPECT_EQ(KeyParser().Feed("\x01\xc3\xa4\x7f"
                             "b"),
            std::vector<Key>{Character('b')});
}

TEST(KeyParser, ALoneEscapeIsTheEscapeKeyAfterAWhile) {
  KeyParser dut;
  EXPECT_TRUE(dut.Feed("\x1b").empty());
  EXPECT_EQ(dut.Flush(), std::vector<Key>{{Kind::kEscape}});
  EXPECT_EQ(dut.Feed("[A"), (std::vector<Key>{Character('['), Character('A')}));
}

TEST(KeyParser, EscapeBeforeAnotherKeyIsBothOfThem) {
  EXPECT_EQ(KeyParser().Feed("\x1b"
                             "x"),
            (std::vector<Key>{{Kind::kEscape}, Character('x')}));
}

TEST(KeyParser, EndlessSequencesAreForgotten) {
  KeyParser dut;
  dut.Feed("\x1b[" + std::string(100, '1'));
  EXPECT_EQ(dut.Feed("ab").back(), Character('b'));
}

TEST(Keyboard, AMotionKeyHoldsItsMotionFor300MillisecondsAfterTheLastRepeat) {
  OperatorHands hands;
  PressKey({.kind = Kind::kUp}, At(seconds(0)), hands);
  PressKey({.kind = Kind::kUp}, At(milliseconds(250)), hands);
  hands.Tick(At(milliseconds(549)));
  EXPECT_TRUE(hands.inputs().controls.motion[0]);
  hands.Tick(At(milliseconds(550)));
  EXPECT_FALSE(hands.inputs().controls.motion[0]);
}

TEST(Keyboard, AKeyThatRepeatsEndsItsMotionSoonAfterItIsLetGo) {
  OperatorHands hands;
  PressKey({.kind = Kind::kUp}, At(seconds(0)), hands);
  PressKey({.kind = Kind::kUp}, At(milliseconds(500)), hands, kRepeatHoldTime);
  hands.Tick(At(milliseconds(649)));
  EXPECT_TRUE(hands.inputs().controls.motion[0]);
  hands.Tick(At(milliseconds(650)));
  EXPECT_FALSE(hands.inputs().controls.motion[0]);
}

TEST(Keyboard, ReachesAll22Motions) {
  OperatorHands hands;
  for (const Kind kind : {Kind::kUp, Kind::kDown, Kind::kLeft, Kind::kRight}) {
    PressKey({.kind = kind}, At(seconds(0)), hands);
  }
  for (const char c : std::string("yhujqawsedrftgopik")) {
    EXPECT_EQ(PressKey(Character(c), At(seconds(0)), hands), KeyOutcome::kDone) << c;
  }
  for (const bool pressed : hands.inputs().controls.motion) EXPECT_TRUE(pressed);
}

TEST(Keyboard, SpacePressesTheEstopAndZReleasesIt) {
  OperatorHands hands;
  PressKey(Character(' '), At(seconds(0)), hands);
  EXPECT_TRUE(hands.inputs().estop_pressed);
  PressKey(Character(' '), At(seconds(0)), hands);
  EXPECT_TRUE(hands.inputs().estop_pressed);
  PressKey(Character('z'), At(seconds(0)), hands);
  EXPECT_FALSE(hands.inputs().estop_pressed);
}

TEST(Keyboard, ControlKeysMoveTheirControls) {
  OperatorHands hands;
  const auto press = [&hands](char c) { PressKey(Character(c), At(seconds(0)), hands); };
  const dbc::PanelState& controls = hands.inputs().controls;
  press('m');
  EXPECT_EQ(controls.key, dbc::KeySwitch::kStandby);
  press('m');
  EXPECT_EQ(controls.key, dbc::KeySwitch::kOperate);
  press('m');
  EXPECT_EQ(controls.key, dbc::KeySwitch::kOff);
  press('x');
  EXPECT_EQ(controls.deadman, dbc::Deadman::kEnabled);
  press('x');
  EXPECT_EQ(controls.deadman, dbc::Deadman::kReleased);
  press('3');
  EXPECT_EQ(controls.speed_range, dbc::SpeedRange::kHigh);
  press(',');
  EXPECT_DOUBLE_EQ(controls.speed_limit, 0.9);
  press('.');
  press('.');
  EXPECT_DOUBLE_EQ(controls.speed_limit, 1.0);
  press('n');
  EXPECT_EQ(controls.reset, dbc::Button::kPressed);
  press('v');
  EXPECT_TRUE(controls.lamp_test);
  PressKey({.kind = Kind::kEnter}, At(seconds(0)), hands);
  EXPECT_EQ(controls.start, dbc::Button::kPressed);
  hands.Tick(At(milliseconds(1500)));
  EXPECT_FALSE(controls.lamp_test);
}

TEST(Keyboard, CapitalMGoesRoundTheExercises) {
  OperatorHands hands;
  for (const int exercise : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1}) {
    PressKey(Character('M'), At(seconds(0)), hands);
    EXPECT_EQ(hands.inputs().controls.menu_exercise, exercise);
  }
}

TEST(Keyboard, EightGoesRoundTheFiveModulesAndTheMenuKeysPressTheirKey) {
  OperatorHands hands;
  const auto press = [&hands](char c) { PressKey(Character(c), At(seconds(0)), hands); };
  for (const auto module : {dbc::Module::kFlat, dbc::Module::kSlope, dbc::Module::kBomb,
                            dbc::Module::kOutdoor, dbc::Module::kIndoor, dbc::Module::kFlat}) {
    press('8');
    EXPECT_EQ(hands.inputs().controls.menu_module, module);
  }
  const std::vector<std::pair<char, dbc::MenuCommand>> keys{{'9', dbc::MenuCommand::kStart},
                                                            {'6', dbc::MenuCommand::kPause},
                                                            {'7', dbc::MenuCommand::kResume},
                                                            {'0', dbc::MenuCommand::kReset},
                                                            {'E', dbc::MenuCommand::kEnd}};
  for (const auto& [key, command] : keys) {
    press(key);
    EXPECT_EQ(hands.inputs().controls.menu_command, command) << key;
  }
}

TEST(Keyboard, CapitalsRequestThePresetsWhileTheyRepeat) {
  const std::string keys = "STGCDUJ";  // stow 1 to stair down 7
  for (int preset = 1; preset <= 7; ++preset) {
    OperatorHands hands;
    const Key key = Character(keys[preset - 1]);
    PressKey(key, At(seconds(0)), hands);
    PressKey(key, At(milliseconds(250)), hands);
    hands.Tick(At(milliseconds(549)));
    EXPECT_EQ(hands.inputs().controls.preset, preset);
    hands.Tick(At(milliseconds(550)));
    EXPECT_EQ(hands.inputs().controls.preset, 0) << "let go 0.3 s after the last repeat";
  }
}

TEST(Keyboard, AnotherPresetKeyTakesOverAtOnce) {
  OperatorHands hands;
  PressKey(Character('S'), At(seconds(0)), hands);
  PressKey(Character('C'), At(milliseconds(100)), hands);
  EXPECT_EQ(hands.inputs().controls.preset, 4);
  hands.Tick(At(milliseconds(399)));
  EXPECT_EQ(hands.inputs().controls.preset, 4);
  hands.Tick(At(milliseconds(400)));
  EXPECT_EQ(hands.inputs().controls.preset, 0);
}

TEST(Keyboard, FirePanelCanBeArmedAndFiredWithTwoKeys) {
  OperatorHands hands;
  const dbc::PanelState& controls = hands.inputs().controls;
  PressKey(Character('A'), At(seconds(0)), hands);
  EXPECT_EQ(controls.arm_key, dbc::FireContact::kOn);
  for (const int circuit : {1, 2, 3, 0, 1}) {
    PressKey(Character('N'), At(seconds(0)), hands);
    EXPECT_EQ(controls.circuit, circuit);
  }
  // Fire rule 7 wants both buttons pressed within 500 ms of each other and then held for 300 ms.
  PressKey(Character('L'), At(milliseconds(1000)), hands);
  PressKey(Character('R'), At(milliseconds(1400)), hands);
  hands.Tick(At(milliseconds(1999)));
  EXPECT_EQ(controls.fire_left, dbc::FireContact::kOn);
  EXPECT_EQ(controls.fire_right, dbc::FireContact::kOn);
  hands.Tick(At(milliseconds(2000)));
  EXPECT_EQ(controls.fire_left, dbc::FireContact::kOff);
  hands.Tick(At(milliseconds(2400)));
  EXPECT_EQ(controls.fire_right, dbc::FireContact::kOff);
  PressKey(Character('A'), At(seconds(3)), hands);
  EXPECT_EQ(controls.arm_key, dbc::FireContact::kOff);
}

TEST(Keyboard, LightJointRateAndAlarmResetHaveKeys) {
  OperatorHands hands;
  const auto press = [&hands](char c) { PressKey(Character(c), At(seconds(0)), hands); };
  const dbc::PanelState& controls = hands.inputs().controls;
  for (const int light : {1, 2, 3, 0}) {
    press('l');
    EXPECT_EQ(controls.light, light);
  }
  press('5');
  EXPECT_DOUBLE_EQ(controls.joint_rate, 1.0) << "no more than all";
  for (int i = 0; i < 12; ++i) press('4');
  EXPECT_DOUBLE_EQ(controls.joint_rate, 0.1) << "never none: a dead key would puzzle";
  press('5');
  EXPECT_DOUBLE_EQ(controls.joint_rate, 0.2);
  press('B');
  EXPECT_TRUE(controls.alarm_reset);
}

TEST(Keyboard, CapitalQQuitsAndUnknownKeysDoNothing) {
  OperatorHands hands;
  const PanelInputs before = hands.inputs();
  EXPECT_EQ(PressKey(Character('Q'), At(seconds(0)), hands), KeyOutcome::kQuit);
  EXPECT_EQ(PressKey(Character('#'), At(seconds(0)), hands), KeyOutcome::kUnused);
  EXPECT_EQ(PressKey({.kind = Kind::kEscape}, At(seconds(0)), hands), KeyOutcome::kUnused);
  EXPECT_EQ(hands.inputs(), before);
}

}  // namespace
}  // namespace eod::box
