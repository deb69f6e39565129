#include "firmware_emu/indicators.h"

#include <gtest/gtest.h>

#include "tests/unit/firmware_emu/box_rig.h"

namespace eod::box {
namespace {

using dbc::BuzzerPattern;
using dbc::LampPattern;

// Times per second that a lamp goes on, and share of the time that it is lit, over 10 s.
struct Blinking {
  int flashes = 0;
  int lit_ms = 0;
};

Blinking Watch(LampPattern pattern) {
  Blinking seen;
  bool last = false;
  for (int ms = 0; ms < 10000; ++ms) {
    const bool lit = IsLit(pattern, At(milliseconds(ms)));
    seen.flashes += lit && !last ? 1 : 0;
    seen.lit_ms += lit ? 1 : 0;
    last = lit;
  }
  return seen;
}

TEST(Lamp, SlowBlinkFlashesOnceASecondHalfOfTheTime) {
  const Blinking seen = Watch(LampPattern::kSlowBlink);
  EXPECT_EQ(seen.flashes, 10);
  EXPECT_EQ(seen.lit_ms, 5000);
}

TEST(Lamp, FastBlinkFlashesFourTimesASecondHalfOfTheTime) {
  const Blinking seen = Watch(LampPattern::kFastBlink);
  EXPECT_EQ(seen.flashes, 40);
  EXPECT_EQ(seen.lit_ms, 5000);
}

TEST(Lamp, OnIsAlwaysLitAndOffNever) {
  EXPECT_EQ(Watch(LampPattern::kOn).lit_ms, 10000);
  EXPECT_EQ(Watch(LampPattern::kOff).lit_ms, 0);
}

int SoundingMilliseconds(BuzzerPattern pattern, int until_ms) {
  int count = 0;
  for (int ms = 0; ms < until_ms; ++ms) count += IsSounding(pattern, milliseconds(ms)) ? 1 : 0;
  return count;
}

TEST(Buzzer, PatternsSoundAsLongAsTheySay) {
  EXPECT_EQ(SoundingMilliseconds(BuzzerPattern::kOff, 4000), 0);
  EXPECT_EQ(SoundingMilliseconds(BuzzerPattern::kBeep, 4000), 150);
  EXPECT_EQ(SoundingMilliseconds(BuzzerPattern::kSlow, 4000), 2000);
  EXPECT_EQ(SoundingMilliseconds(BuzzerPattern::kFast, 4000), 2000);
  EXPECT_EQ(SoundingMilliseconds(BuzzerPattern::kContinuous, 4000), 4000);
  EXPECT_EQ(SoundingMilliseconds(BuzzerPattern::kSuccess, 4000), 300);
  EXPECT_EQ(SoundingMilliseconds(BuzzerPattern::kFailure, 4000), 1000);
}

TEST(Buzzer, SuccessIsTwoBeeps) {
  EXPECT_TRUE(IsSounding(BuzzerPattern::kSuccess, milliseconds(149)));
  EXPECT_FALSE(IsSounding(BuzzerPattern::kSuccess, milliseconds(150)));
  EXPECT_TRUE(IsSounding(BuzzerPattern::kSuccess, milliseconds(300)));
  EXPECT_FALSE(IsSounding(BuzzerPattern::kSuccess, milliseconds(450)));
}

TEST(Buzzer, FastSoundsFourTimesASecondAndSlowOnce) {
  EXPECT_TRUE(IsSounding(BuzzerPattern::kFast, milliseconds(250)));
  EXPECT_FALSE(IsSounding(BuzzerPattern::kFast, milliseconds(130)));
  EXPECT_TRUE(IsSounding(BuzzerPattern::kSlow, milliseconds(499)));
  EXPECT_FALSE(IsSounding(BuzzerPattern::kSlow, milliseconds(500)));
}

}  // namespace
}  // namespace eod::box
