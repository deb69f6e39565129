#include "recorder/status_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eod::recorder {
namespace {

using testing::HasSubstr;
using testing::Not;

LiveStatus InContact() {
  LiveStatus status;
  status.t = 12.34;
  status.lamps[static_cast<size_t>(dbc::Lamp::kPower)] = dbc::LampPattern::kOn;
  status.lamps[static_cast<size_t>(dbc::Lamp::kCollision)] = dbc::LampPattern::kFastBlink;
  status.speed_mps = -0.3;
  status.inhibit_mask = 0b1;
  status.camera_fps = 29.6;
  status.link = LinkSeen{.bus_state = 0, .quality = 0.99};
  status.mission.state = MissionState::kRun;
  status.mission.step = 0;
  status.mission.steps = 4;
  status.mission.step_text = "Drive forward until the wall stops you";
  return status;
}

TEST(StatusLine, ShowsWhatTheOperatorAsksFor) {
  EXPECT_EQ(FormatStatusLine(InContact(), {.columns = 160, .colour = false}),
            "  12.3 s  PWR COL*  -0.30 m/s  inhibited M01  30 fps  link 99%  "
            "1/4 Drive forward until the wall stops you");
}

TEST(StatusLine, NeverExceedsTheColumns) {
  for (int columns = 20; columns <= 120; ++columns) {
    const std::string line = FormatStatusLine(InContact(), {.columns = columns, .colour = false});
    EXPECT_LE(line.size(), static_cast<size_t>(columns));
  }
}

TEST(StatusLine, KeepsColoursWholeWhenNarrow) {
  // Each tag begins one escape and ends it: their numbers stay equal.
  for (int columns = 20; columns <= 120; ++columns) {
    const std::string line = FormatStatusLine(InContact(), {.columns = columns, .colour = true});
    size_t begun = 0;
    size_t ended = 0;
    for (size_t at = line.find("\033["); at != std::string::npos; at = line.find("\033[", at + 1)) {
      (line.compare(at, 4, "\033[0m") == 0 ? ended : begun) += 1;
    }
    EXPECT_EQ(begun, ended);
  }
}

TEST(StatusLine, CutsTextBetweenCharacters) {
  LiveStatus status = InContact();
  status.mission.step_text = "äöüäöüäöüäöüäöüäöüäöü";
  // 68 columns come before the text; of "äöü…" 10 characters remain, each of 2 bytes.
  const std::string line = FormatStatusLine(status, {.columns = 78, .colour = false});
  EXPECT_TRUE(line.ends_with("äöüäöüäöüä")) << line;
}

TEST(StatusLine, ShowsTheScriptWhileNoMissionRuns) {
  LiveStatus status = InContact();
  status.mission.state = MissionState::kIdle;
  status.script_line = "estop press";
  EXPECT_THAT(FormatStatusLine(status, {.columns = 160, .colour = false}),
              HasSubstr("link 99%  estop press"));
}

TEST(StatusLine, SaysWhenTheBusIsGone) {
  LiveStatus status = InContact();
  status.link->bus_state = 1;
  const std::string line = FormatStatusLine(status, {.columns = 160, .colour = false});
  EXPECT_THAT(line, HasSubstr("link bus down"));
  EXPECT_THAT(line, Not(HasSubstr("99%")));
}

TEST(MotionNames, AreNumbersNoneOrAll) {
  EXPECT_EQ(MotionNames(0), "none");
  EXPECT_EQ(MotionNames(0b101), "M01 M03");
  EXPECT_EQ(MotionNames((1U << 22) - 1), "all");
}

}  // namespace
}  // namespace eod::recorder
