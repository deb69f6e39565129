#include "batch/progress_line.h"

#include <gtest/gtest.h>

namespace eod::batch {
namespace {

using std::chrono::seconds;

const BatchProgress kHalf{
    .planned = 40, .found = 5, .driven = 15, .unexpected = 1, .simulated_s = 3000};

TEST(ProgressLine, SaysHowFarHowFastAndHowLong) {
  // 15 runs took 30 s, so the 20 that are left take 40.
  EXPECT_EQ(ProgressLine(kHalf, seconds(30), 0),
            "20 of 40 runs (5 found done), 1 not as expected, 100 times real time, 0:40 left");
}

TEST(ProgressLine, HasABarOnATerminalAndKeepsToItsWidth) {
  const std::string line = ProgressLine(kHalf, seconds(30), 200);
  EXPECT_EQ(line.substr(0, 27), "[============            ] ");
  EXPECT_EQ(ProgressLine(kHalf, seconds(30), 40), line.substr(0, 40));
}

TEST(ProgressLine, SaysHoursOfLongBatches) {
  EXPECT_TRUE(ProgressLine(kHalf, seconds(3000), 0).ends_with("1:06:40 left"));
}

TEST(ProgressLine, HasNoTimeBeforeTheFirstRunNorAfterTheLast) {
  EXPECT_EQ(ProgressLine({.planned = 40}, seconds(1), 0), "0 of 40 runs");
  EXPECT_EQ(ProgressLine({.planned = 4, .found = 4}, seconds(1), 0), "4 of 4 runs (4 found done)");
}

}  // namespace
}  // namespace eod::batch
