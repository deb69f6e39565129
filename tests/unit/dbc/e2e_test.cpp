#include "dbc/e2e.h"

#include <array>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eod::dbc {
namespace {

using testing::ElementsAre;
using enum E2eStatus;

/// Statuses of good frames with these counters.
std::vector<E2eStatus> CheckAll(E2eChecker& dut, const std::vector<int>& counters) {
  std::vector<E2eStatus> statuses;
  for (const int counter : counters) statuses.push_back(dut.Check(true, counter));
  return statuses;
}

TEST(E2eCrc, HasTheGoldenValues) {
  std::array<uint8_t, 8> payload{};
  EXPECT_EQ(E2eCrc(0x0123, payload, 0), 0xCC);
  payload[1] = 1;  // the counter
  EXPECT_EQ(E2eCrc(0x0123, payload, 0), 0x91);
}

TEST(E2eCrc, LeavesOutTheCrcByteWhereverItIs) {
  std::array<uint8_t, 8> payload{1, 2, 3, 4, 5, 6, 7, 8};
  for (int crc_byte = 0; crc_byte < 8; ++crc_byte) {
    auto other = payload;
    other[static_cast<size_t>(crc_byte)] ^= 0xFF;
    EXPECT_EQ(E2eCrc(0x190, payload, crc_byte), E2eCrc(0x190, other, crc_byte));
  }
}

TEST(E2eCrc, SeesEverySingleAndDoubleBitErrorOfAFrame) {
  const std::array<uint8_t, 8> payload{0, 0x20, 0x05, 0x11, 0xC8, 0x00, 0x78, 0x10};
  const uint8_t good = E2eCrc(0x190, payload, 0);
  for (int a = 8; a < 64; ++a) {
    for (int b = a; b < 64; ++b) {
      auto damaged = payload;
      damaged[static_cast<size_t>(a / 8)] ^= static_cast<uint8_t>(1 << a % 8);
      if (b != a) damaged[static_cast<size_t>(b / 8)] ^= static_cast<uint8_t>(1 << b % 8);
      EXPECT_NE(E2eCrc(0x190, damaged, 0), good) << a << ' ' << b;
    }
  }
}

TEST(E2eChecker, JudgesEveryAdvanceOfTheCounter) {
  for (int last = 0; last < kE2eCounterCount; ++last) {
    for (int advance = 0; advance < kE2eCounterCount; ++advance) {
      E2eChecker dut;
      EXPECT_EQ(dut.Check(true, last), kInitial);
      const E2eStatus expected = advance == 0   ? kRepeated
                                 : advance == 1 ? kOk
                                 : advance <= 3 ? kOkSomeLost
                                                : kWrongSequence;
      EXPECT_EQ(dut.Check(true, (last + advance) % kE2eCounterCount), expected)
          << last << " + " << advance;
      EXPECT_EQ(dut.lost(), advance > 1 ? static_cast<uint64_t>(advance - 1) : 0u);
    }
  }
}

TEST(E2eChecker, WrapsFrom14To0) {
  E2eChecker dut;
  EXPECT_THAT(CheckAll(dut, {13, 14, 0, 1}), ElementsAre(kInitial, kOk, kOk, kOk));
}

TEST(E2eChecker, NeverTakes15) {
  E2eChecker dut;
  EXPECT_EQ(dut.Check(true, 15), kWrongSequence);
  EXPECT_EQ(dut.Check(true, -1), kWrongSequence);
}

TEST(E2eChecker, TrustsTheThirdGoodFrameAfterAWrongSequence) {
  E2eChecker dut;
  EXPECT_THAT(CheckAll(dut, {0, 5, 6, 7, 8, 9}),
              ElementsAre(kInitial, kWrongSequence, kSync, kSync, kOk, kOk));
}

TEST(E2eChecker, CountsGoodFramesInARowOnly) {
  // A repetition, a bad CRC, and another jump each start the count anew.
  E2eChecker dut;
  EXPECT_THAT(CheckAll(dut, {0, 5, 6, 7, 7, 8, 9, 10}),
              ElementsAre(kInitial, kWrongSequence, kSync, kSync, kRepeated, kSync, kSync, kOk));
  EXPECT_EQ(dut.Check(true, 0), kWrongSequence);
  EXPECT_EQ(dut.Check(true, 1), kSync);
  EXPECT_EQ(dut.Check(false, 2), kWrongCrc);
  EXPECT_THAT(CheckAll(dut, {3, 4, 5}), ElementsAre(kSync, kSync, kOk));
}

TEST(E2eChecker, ABadCrcCostsOneFrameOnly) {
  E2eChecker dut;
  EXPECT_THAT(CheckAll(dut, {0, 1}), ElementsAre(kInitial, kOk));
  EXPECT_EQ(dut.Check(false, 2), kWrongCrc);
  EXPECT_EQ(dut.Check(true, 3), kOkSomeLost);
  EXPECT_EQ(dut.lost(), 1u);
}

TEST(E2eChecker, BeginsAnewAfterReset) {
  E2eChecker dut;
  CheckAll(dut, {0, 9});
  dut.Reset();
  EXPECT_THAT(CheckAll(dut, {4, 5}), ElementsAre(kInitial, kOk));
  EXPECT_EQ(dut.lost(), 8u);  // the jump from 0 to 9 stays counted
}

}  // namespace
}  // namespace eod::dbc
