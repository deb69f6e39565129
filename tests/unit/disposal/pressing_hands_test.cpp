#include "sim/disposal/pressing_hands.h"

#include <gtest/gtest.h>

#include "tests/unit/disposal/bench.h"

namespace eod::sim {
namespace {

TEST(PressingHands, AHandThatAPadHasStoppedGoesOnWhenThePadIsBackByHalf) {
  Bench bench;
  bench.Open(0.12, 0.05);
  // The right pad, 5 mm thick, is pressed in by 60 mm of radius less what is left of the way.
  const auto is_stopped_at = [&](double press) {
    bench.Open(0.12, 0.05);
    bench.PlaceInHand(press - 0.06 + 0.05, 0);
    bench.Step(DemandFor({kGripperClose}));
    return Contains(bench.response.right_hand_blocked, kGripperClose);
  };
  EXPECT_FALSE(is_stopped_at(0.0049));
  EXPECT_TRUE(is_stopped_at(0.0051));
  EXPECT_TRUE(is_stopped_at(0.0026));
  EXPECT_FALSE(is_stopped_at(0.0024));
  EXPECT_FALSE(is_stopped_at(0.0049));
}

}  // namespace
}  // namespace eod::sim
