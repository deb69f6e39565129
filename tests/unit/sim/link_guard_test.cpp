#include "sim/radio/link_guard.h"

#include <gtest/gtest.h>

namespace eod::sim {
namespace {

using std::chrono::milliseconds;
constexpr TimePoint At(int ms) { return TimePoint{milliseconds(ms)}; }

TEST(LinkGuard, PermitsWhileCommandsAreNotOlderThanATenthOfASecond) {
  LinkGuard dut;
  dut.Accept(At(0), false, 0);
  dut.Advance(At(100));
  EXPECT_TRUE(dut.motion_permitted());
  EXPECT_EQ(dut.silence(), Duration::zero());
  dut.Advance(At(101));
  EXPECT_FALSE(dut.motion_permitted());
  EXPECT_EQ(dut.silence(), milliseconds(101));
}

TEST(LinkGuard, RampsToZeroWithinAFifthOfASecondFromTheMomentOfTheLoss) {
  LinkGuard dut;
  dut.Accept(At(0), false, 0);
  for (const int ms : {140, 200, 280}) {
    dut.Advance(At(ms));
    EXPECT_NEAR(dut.ramp_share(), 1 - (ms - 100) / 200.0, 1e-12);
  }
  dut.Advance(At(300));
  EXPECT_EQ(dut.ramp_share(), 0);
}

TEST(LinkGuard, ClearsItselfWithTheFirstNeutralCommand) {
  LinkGuard dut;
  dut.Accept(At(0), false, 0);
  dut.Advance(At(400));
  dut.Accept(At(404), false, 0);
  EXPECT_FALSE(dut.motion_permitted());
  EXPECT_TRUE(dut.needs_neutral());
  dut.Accept(At(420), true, 0);
  EXPECT_TRUE(dut.motion_permitted());
}

TEST(LinkGuard, LatchesAfterHalfASecondUntilANewResetAndNeutralControls) {
  LinkGuard dut;
  dut.Accept(At(0), false, 3);
  dut.Advance(At(500));
  EXPECT_FALSE(dut.is_latched());
  dut.Advance(At(501));
  EXPECT_TRUE(dut.is_latched());
  dut.Accept(At(510), true, 3);
  EXPECT_FALSE(dut.motion_permitted());
  dut.Accept(At(530), false, 4);
  EXPECT_FALSE(dut.is_latched());
  EXPECT_FALSE(dut.motion_permitted());
  dut.Accept(At(550), true, 4);
  EXPECT_TRUE(dut.motion_permitted());
}

TEST(LinkGuard, SilenceBetweenTwoCommandsCountsThoughNobodyLooked) {
  LinkGuard dut;
  dut.Accept(At(0), true, 0);
  dut.Accept(At(600), true, 0);
  EXPECT_TRUE(dut.is_latched());
}

TEST(LinkGuard, BeforeTheFirstCommandNothingIsMissed) {
  LinkGuard dut;
  dut.Advance(At(5000));
  EXPECT_EQ(dut.silence(), Duration::zero());
  EXPECT_FALSE(dut.is_latched());
}

}  // namespace
}  // namespace eod::sim
