#include "recorder/step_watch.h"

#include <gtest/gtest.h>

namespace eod::recorder {
namespace {

using std::chrono::milliseconds;

TimePoint At(int ms) { return TimePoint{milliseconds(ms)}; }

TEST(StepWatch, FindsThePeriodAndTheSimulatedTime) {
  StepWatch dut;
  for (int step = 0; step <= 250; ++step) dut.Add(At(4 * step), step, 0);
  EXPECT_EQ(dut.period(), milliseconds(4));
  EXPECT_EQ(dut.simulated(), milliseconds(1000));
  EXPECT_EQ(dut.overruns(), 0);
}

TEST(StepWatch, CountsTheOverrunsThatTheSimulatorTellsWhileItWatches) {
  StepWatch dut;
  dut.Add(At(0), 0, 7);
  dut.Add(At(4), 1, 7);
  dut.Add(At(8), 2, 9);
  dut.Add(At(12), 3, 9);
  EXPECT_EQ(dut.overruns(), 2);
  EXPECT_EQ(dut.period(), milliseconds(4));
}

TEST(StepWatch, LeavesStepsThatWereLeftOutOutOfThePeriod) {
  // A pause of 400 ms: step 2 comes at 408 ms, with 100 overruns.
  StepWatch dut;
  dut.Add(At(0), 0, 0);
  dut.Add(At(4), 1, 0);
  dut.Add(At(408), 2, 100);
  dut.Add(At(412), 3, 100);
  EXPECT_EQ(dut.period(), milliseconds(4));
  EXPECT_EQ(dut.simulated(), milliseconds(12));
}

TEST(StepWatch, DoesNotTakeALostMessageForAnOverrun) {
  StepWatch dut;
  dut.Add(At(0), 0, 0);
  dut.Add(At(4), 1, 0);
  dut.Add(At(16), 4, 0);
  EXPECT_EQ(dut.overruns(), 0);
  EXPECT_EQ(dut.simulated(), milliseconds(16));
}

TEST(StepWatch, GoesOnWhenTheSimulatorStartsAgain) {
  StepWatch dut;
  dut.Add(At(0), 0, 0);
  dut.Add(At(4), 1, 5);
  dut.Add(At(3000), 0, 0);
  dut.Add(At(3004), 1, 0);
  EXPECT_EQ(dut.overruns(), 5);
  EXPECT_EQ(dut.simulated(), milliseconds(8));
}

}  // namespace
}  // namespace eod::recorder
