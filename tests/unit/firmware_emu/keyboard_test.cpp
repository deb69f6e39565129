// Terminal bytes to keys, keys to controls, status to screen.
#include "firmware_emu/keyboard.h"

#include <gtest/gtest.h>

#include "firmware_emu/panel_journal.h"
#include "firmware_emu/panel_screen.h"
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

TEST(Keyboard, CapitalQQuitsAndUnknownKeysDoNothing) {
  OperatorHands hands;
  const PanelInputs before = hands.inputs();
  EXPECT_EQ(PressKey(Character('Q'), At(seconds(0)), hands), KeyOutcome::kQuit);
  EXPECT_EQ(PressKey(Character('#'), At(seconds(0)), hands), KeyOutcome::kUnused);
  EXPECT_EQ(PressKey({.kind = Kind::kEscape}, At(seconds(0)), hands), KeyOutcome::kUnused);
  EXPECT_EQ(hands.inputs(), before);
}

// Visible width of each line: escape sequences take no room.
std::vector<size_t> LineWidths(const std::string& screen) {
  std::vector<size_t> widths(1, 0);
  for (size_t i = 0; i < screen.size(); ++i) {
    if (screen[i] == '\x1b') {
      while (i + 1 < screen.size() && std::isalpha(screen[i]) == 0) ++i;
    } else if (screen[i] == '\n') {
      widths.push_back(0);
    } else if (screen[i] != '\r') {
      ++widths.back();
    }
  }
  return widths;
}

TEST(Screen, FitsInto80By24WithEverythingShown) {
  PanelStatus status;
  status.feedback.inhibit_mask = 0x3FFFFF;
  status.feedback.hit_parts = 0xFFF;
  status.feedback.joint.fill(-179.99);
  status.feedback.inhibit_reason = dbc::InhibitReason::kNeutralNeeded;
  status.reported.motion.fill(true);
  status.lit.fill(true);
  status.rx = 4000000000u;
  const std::vector<size_t> widths = LineWidths(DrawPanel(status, {}));
  EXPECT_LE(widths.size(), static_cast<size_t>(kScreenHeight));
  EXPECT_GE(widths.size(), 20u);
  for (const size_t width : widths) EXPECT_LE(width, static_cast<size_t>(kScreenWidth));
}

TEST(Screen, ShowsLitLampsInColourAndInhibitedMotions) {
  PanelStatus status;
  status.feedback.inhibit_mask = 1;
  status.feedback.inhibit_reason = dbc::InhibitReason::kCollision;
  const std::string dark = DrawPanel(status, {});
  EXPECT_NE(dark.find("Inhibited M01 (collision)"), std::string::npos);
  EXPECT_EQ(dark.find("\x1b[97;41m"), std::string::npos);
  EXPECT_EQ(DrawPanel(PanelStatus{}, {}).find("Inhibited none ("), std::string::npos);
  status.lit[static_cast<size_t>(dbc::Lamp::kCollision)] = true;
  EXPECT_NE(DrawPanel(status, {}).find("\x1b[97;41mcollision \x1b[0m"), std::string::npos);
}

TEST(Journal, TellsEachChangeOnce) {
  PanelJournal dut;
  PanelStatus status;
  EXPECT_TRUE(dut.Observe(status).empty());
  status.lamp[static_cast<size_t>(dbc::Lamp::kCollision)] = dbc::LampPattern::kFastBlink;
  status.feedback.inhibit_mask = 1;
  status.feedback.inhibit_reason = dbc::InhibitReason::kCollision;
  status.feedback.hit_parts = 3;
  EXPECT_EQ(dut.Observe(status),
            (std::vector<std::string>{"lamp collision fast", "inhibited M01 (collision)",
                                      "contact front left wheel, front right wheel"}));
  EXPECT_TRUE(dut.Observe(status).empty());
}

}  // namespace
}  // namespace eod::box
