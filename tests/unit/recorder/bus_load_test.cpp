#include "recorder/bus_load.h"

#include <gtest/gtest.h>

namespace eod::recorder {
namespace {

using std::chrono::milliseconds;

CanFrame FrameAt(milliseconds t) {
  CanFrame frame;
  frame.length = 8;
  frame.stamp = TimePoint{t};
  return frame;
}

TEST(BusLoad, IsTheShareOfBitsThatFramesTake) {
  // An 8-byte standard frame has at most 34 + 64 + 13 + (98 - 1) / 4 = 135 bits. 100 of them, one a
  // millisecond, on 500 kbit/s: 135 / 500 = 27 %.
  BusLoad dut(500'000);
  for (int i = 0; i <= 100; ++i) dut.Add(FrameAt(milliseconds(i)));
  EXPECT_NEAR(dut.percent(), 27.0, 1e-9);
}

TEST(BusLoad, DoublesAtHalfTheBitRate) {
  BusLoad dut(250'000);
  for (int i = 0; i <= 100; ++i) dut.Add(FrameAt(milliseconds(i)));
  EXPECT_NEAR(dut.percent(), 54.0, 1e-9);
}

TEST(BusLoad, IsZeroWithoutAWindow) {
  BusLoad dut(500'000);
  EXPECT_EQ(dut.percent(), 0.0);
  dut.Add(FrameAt(milliseconds(5)));
  EXPECT_EQ(dut.percent(), 0.0);
}

}  // namespace
}  // namespace eod::recorder
