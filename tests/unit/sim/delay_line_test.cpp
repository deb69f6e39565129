#include "sim/radio/delay_line.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/counting_new.h"

namespace eod::sim {
namespace {

using std::chrono::milliseconds;
constexpr auto kStream = LinkStream::kCommands;

TEST(DelayLine, DeliversAtExactlyTheDelay) {
  DelayLine<int> dut({.delay = 0.2}, 1, kStream, 64);
  const TimePoint sent{milliseconds(1000)};
  *dut.Send(sent) = 7;
  EXPECT_EQ(dut.Receive(sent + milliseconds(200) - Duration(1)), nullptr);
  const int* message = dut.Receive(sent + milliseconds(200));
  ASSERT_NE(message, nullptr);
  EXPECT_EQ(*message, 7);
  EXPECT_EQ(dut.arrived(), sent + milliseconds(200));
  EXPECT_EQ(dut.Receive(sent + milliseconds(900)), nullptr);
}

TEST(DelayLine, LosesItsShareWithinTheBoundsOfChance) {
  constexpr int kMessages = 20000;
  for (const double loss : {0.01, 0.05, 0.2}) {
    for (const double drop : {0.0, 0.5}) {
      DelayLine<int> dut({.loss = loss}, 42, kStream, 1);
      for (int i = 0; i < kMessages; ++i) {
        const TimePoint now{milliseconds(i)};
        dut.Send(now, drop);
        dut.Receive(now);
      }
      const double p = 1 - (1 - loss) * (1 - drop);
      const double sigma = std::sqrt(kMessages * p * (1 - p));
      EXPECT_NEAR(static_cast<double>(dut.lost()), kMessages * p, 4 * sigma);
    }
  }
}

TEST(DelayLine, JitterSpreadsWithinItsBoundsAndKeepsTheOrder) {
  DelayLine<int> dut({.delay = 0.1, .jitter = 0.05}, 3, kStream, 64);
  int next = 0;
  double least = 1, most = 0;
  for (int i = 0; i < 4000; ++i) {
    const TimePoint now{milliseconds(i)};
    if (i % 20 == 0) *dut.Send(now) = i / 20;
    while (const int* message = dut.Receive(now)) {
      EXPECT_EQ(*message, next++);
      const double delay = ToSeconds(dut.arrived() - TimePoint{milliseconds(20 * *message)});
      least = std::min(least, delay);
      most = std::max(most, delay);
    }
  }
  EXPECT_GE(least, 0.1);
  EXPECT_LE(most, 0.15);
  EXPECT_GT(most - least, 0.04);  // of 0.05, in some 190 draws
}

TEST(DelayLine, TheSameSeedLosesTheSameMessagesAndAnotherSeedOthers) {
  const auto pattern = [](int64_t seed, LinkStream stream) {
    DelayLine<int> dut({.loss = 0.5}, seed, stream, 1);
    std::vector<bool> lost;
    for (int i = 0; i < 200; ++i) {
      lost.push_back(dut.Send(TimePoint{milliseconds(i)}) == nullptr);
      dut.Receive(TimePoint{milliseconds(i)});
    }
    return lost;
  };
  EXPECT_EQ(pattern(1, kStream), pattern(1, kStream));
  EXPECT_NE(pattern(1, kStream), pattern(2, kStream));
  EXPECT_NE(pattern(1, kStream), pattern(1, LinkStream::kTelemetry));
}

TEST(DelayLine, WhatFindsNoRoomIsLost) {
  DelayLine<int> dut({.delay = 0.5}, 1, kStream, 2);
  const TimePoint now{milliseconds(5)};
  EXPECT_NE(dut.Send(now), nullptr);
  EXPECT_NE(dut.Send(now), nullptr);
  EXPECT_EQ(dut.Send(now), nullptr);
  EXPECT_EQ(dut.lost(), 1u);
}

TEST(DelayLine, AllocatesNothing) {
  DelayLine<std::array<double, 40>> dut({.delay = 0.5, .jitter = 0.5, .loss = 0.1}, 1, kStream, 64);
  const long before = AllocationCount();
  for (int i = 0; i < 5000; ++i) {
    const TimePoint now{milliseconds(4 * i)};
    if (auto* slot = dut.Send(now)) slot->fill(i);
    while (dut.Receive(now) != nullptr) {
    }
  }
  EXPECT_EQ(AllocationCount() - before, 0);
}

}  // namespace
}  // namespace eod::sim
