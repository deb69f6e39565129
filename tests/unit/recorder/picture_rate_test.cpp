#include "recorder/picture_rate.h"

#include <gtest/gtest.h>

namespace eod::recorder {
namespace {

TimePoint At(int64_t ms) { return TimePoint{std::chrono::milliseconds(ms)}; }

TEST(PictureRate, CountsPicturesASecond) {
  PictureRate dut;
  for (int64_t ms = 0; ms <= 4000; ms += 40) dut.OnPicture(At(ms), At(ms - 40));
  EXPECT_EQ(dut.frames(), 101);
  EXPECT_DOUBLE_EQ(dut.mean_fps(), 25);
  EXPECT_EQ(dut.FpsAt(At(4000)), 25);
  EXPECT_EQ(dut.FpsAt(At(6000)), 0) << "pictures that stopped must not look alive";
}

TEST(PictureRate, DoesNotCountTheTimeInWhichOthersWereChosen) {
  PictureRate dut;
  for (int64_t ms = 0; ms < 1000; ms += 40) dut.OnPicture(At(ms), At(ms - 40));
  for (int64_t ms = 5000; ms < 6000; ms += 40) dut.OnPicture(At(ms), At(ms - 40));
  EXPECT_DOUBLE_EQ(dut.mean_fps(), 25);
}

TEST(PictureRate, CountsTheTimeInWhichNobodyWasShown) {
  PictureRate dut;
  TimePoint last = At(0);
  for (const int64_t ms : {0, 40, 1040, 1080}) {
    dut.OnPicture(At(ms), last);
    last = At(ms);
  }
  EXPECT_DOUBLE_EQ(dut.mean_fps(), 3 / 1.08);
}

}  // namespace
}  // namespace eod::recorder
