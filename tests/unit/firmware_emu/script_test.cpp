#include "firmware_emu/script.h"

#include <filesystem>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/firmware_emu/box_rig.h"

namespace eod::box {
namespace {

using Kind = Statement::Kind;
using testing::HasSubstr;
using testing::StartsWith;

std::string ErrorOf(std::string_view text) {
  try {
    ParseScript(text, "a.boxscript");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Script, ReadsEveryStatement) {
  const Script script = ParseScript(
      "# a comment\n"
      "\n"
      "key operate   # another\n"
      "  wait 2.5s\r\n"
      "wait lamp collision on within 200ms\n"
      "hold M01 M05 for 3s\n"
      "hold M03 until heading >= 88 within 10s\n"
      "expect not inhibit M01\n"
      "note \"look # here\"\n"
      "fail",
      "a.boxscript");
  ASSERT_EQ(script.statements.size(), 8u);
  const std::vector<Statement>& s = script.statements;
  EXPECT_EQ(s[0].kind, Kind::kAction);
  EXPECT_EQ(s[0].line, 3);
  EXPECT_EQ(s[1].kind, Kind::kWaitFor);
  EXPECT_EQ(s[1].duration, milliseconds(2500));
  EXPECT_EQ(s[1].text, "wait 2.5s");
  EXPECT_EQ(s[2].kind, Kind::kWaitUntil);
  EXPECT_EQ(s[2].duration, milliseconds(200));
  EXPECT_EQ(s[3].kind, Kind::kHoldFor);
  EXPECT_EQ(s[3].press.motions, 0b10001u);
  EXPECT_EQ(s[3].release.motions, 0b10001u);
  EXPECT_EQ(s[4].kind, Kind::kHoldUntil);
  EXPECT_EQ(s[4].duration, seconds(10));
  EXPECT_EQ(s[5].kind, Kind::kExpect);
  EXPECT_TRUE(s[5].condition.is_negated);
  EXPECT_EQ(s[6].message, "look # here");
  EXPECT_EQ(s[7].kind, Kind::kFail);
  EXPECT_EQ(s[7].line, 10);
}

TEST(Script, ReadsAPresetThatIsHeld) {
  const Script script = ParseScript(
      "hold preset carry for 5s\n"
      "hold preset stair_down until joint 3 >= 70 within 8s",
      "a.boxscript");
  ASSERT_EQ(script.statements.size(), 2u);
  const std::vector<Statement>& s = script.statements;
  EXPECT_EQ(s[0].kind, Kind::kHoldFor);
  EXPECT_EQ(s[0].press.control, Control::kPreset);
  EXPECT_EQ(s[0].press.choice, 4);
  EXPECT_EQ(s[0].release.control, Control::kPreset);
  EXPECT_EQ(s[0].release.choice, 0);
  EXPECT_EQ(s[1].kind, Kind::kHoldUntil);
  EXPECT_EQ(s[1].press.choice, 7);
  EXPECT_EQ(s[1].duration, seconds(8));
}

TEST(Script, APresetThatIsHeldIsNotNone) {
  EXPECT_EQ(ErrorOf("hold preset none for 1s"),
            "a.boxscript:1: 'none': allowed: stow, travel, ground_pick, carry, can_drop, stair_up, "
            "stair_down");
  EXPECT_EQ(ErrorOf("hold preset carry"), "a.boxscript:1: 'end of line': allowed: for, until");
}

TEST(Script, ErrorsNameFileLineWordAndWhatIsAllowed) {
  EXPECT_THAT(
      ErrorOf("key operate\nlevitate 3s\n"),
      StartsWith(
          "a.boxscript:2: 'levitate': allowed: wait, hold, drive, turn, approach, expect, note, "
          "fail, press"));
  EXPECT_THAT(ErrorOf("wait 3"), StartsWith("a.boxscript:1: '3': allowed: a time such as 2.5s"));
  EXPECT_THAT(ErrorOf("wait 4000s"), HasSubstr("'4000s'"));
  EXPECT_THAT(ErrorOf("wait"), HasSubstr("'end of line': allowed: lamp"));
  EXPECT_EQ(ErrorOf("wait link up"), "a.boxscript:1: 'end of line': allowed: within TIME");
  EXPECT_EQ(ErrorOf("wait link up in 3s"), "a.boxscript:1: 'in': allowed: within TIME");
  EXPECT_EQ(ErrorOf("hold M01 2s"), "a.boxscript:1: '2s': allowed: for, until");
  EXPECT_EQ(ErrorOf("hold for 2s"), "a.boxscript:1: 'for': allowed: M01 .. M22");
  EXPECT_THAT(ErrorOf("hold M01 for -1s"), HasSubstr("'-1s': allowed: a time"));
  EXPECT_THAT(ErrorOf("note"), HasSubstr("'end of line': allowed: a text in double quotes"));
  EXPECT_THAT(ErrorOf("note two words"), HasSubstr("'words': allowed: nothing more"));
  EXPECT_THAT(ErrorOf("note \"open"), HasSubstr("'open': allowed: text in double quotes"));
  EXPECT_THAT(ErrorOf("\n\nreset now"), HasSubstr("a.boxscript:3: 'now': allowed: nothing more"));
}

TEST(Script, MissingFileIsNamed) {
  try {
    LoadScript("no/such.boxscript");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), StartsWith("no/such.boxscript: cannot be read"));
  }
}

TEST(Script, AFolderIsNoScript) {
  EXPECT_THROW(LoadScript(EOD_DATA_DIR "/firmware_emu"), std::runtime_error);
}

TEST(Script, ShippedScriptsAreSound) {
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(EOD_DATA_DIR "/firmware_emu/scripts")) {
    EXPECT_FALSE(LoadScript(entry.path()).statements.empty()) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 3);
}

TEST(Script, ReadsWaysByEye) {
  const Script script = ParseScript(
      "drive to 1.5 -2 backwards within 60s\ndrive to can at 1.05\nturn to -90\nturn to can\n"
      "approach charge_m at 1.2 -0.1 within 90s\ndrive to can\n",
      "a.boxscript");
  const auto way = [&script](size_t i) { return script.statements[i].manoeuvre; };
  EXPECT_EQ(way(0).x, 1.5);
  EXPECT_EQ(way(0).y, -2);
  EXPECT_TRUE(way(0).backwards);
  EXPECT_EQ(script.statements[0].duration, std::chrono::seconds(60));
  EXPECT_EQ(way(1).kind, Manoeuvre::Kind::kApproach);
  EXPECT_EQ(way(1).object, "can");
  EXPECT_EQ(script.statements[1].duration, Manoeuvre::kUsualLimit);
  EXPECT_EQ(way(2).heading_deg, -90);
  EXPECT_EQ(way(3).object, "can");
  EXPECT_EQ(way(4).ahead, 1.2);
  EXPECT_EQ(way(4).side, -0.1);
  EXPECT_EQ(way(5).kind, Manoeuvre::Kind::kDriveTo);
}

TEST(Script, RefusesWaysThatLeadNowhere) {
  EXPECT_EQ(ErrorOf("drive 1 2"), "a.boxscript:1: '1': allowed: to");
  EXPECT_EQ(ErrorOf("approach can"), "a.boxscript:1: 'end of line': allowed: at");
  EXPECT_EQ(ErrorOf("approach can at 0.2"), "a.boxscript:1: '0.2': allowed: 0.4 m or more");
  EXPECT_EQ(ErrorOf("turn to"),
            "a.boxscript:1: 'end of line': allowed: a heading in degrees or the name of an object");
  EXPECT_EQ(ErrorOf("drive to 1"), "a.boxscript:1: 'end of line': allowed: a number");
}

}  // namespace
}  // namespace eod::box
