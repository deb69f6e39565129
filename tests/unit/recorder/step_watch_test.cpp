#include "recorder/step_watch.h"

#include <gtest/gtest.h>

namespace eod::recorder {
namespace {

using std::chrono::milliseconds;

TimePoint At(int ms) { return TimePoint{milliseconds(ms)}; }

TEST(StepWatch, FindsThePeriodAndTheSimulatedTime) {
  StepWatch dut;
  for (int step = 0; step <= 250; ++step) dut.Add(At(4 * step), step);
  EXPECT_EQ(dut.period(), milliseconds(4));
  EXPECT_EQ(dut.simulated(), milliseconds(1000));
  EXPECT_EQ(dut.overruns(), 0);
}

TEST(StepWatch, CountsStepsThatTheSimulatorMissed) {
  // Due at 12 and 16 ms, done at 20 ms only: two periods without a step.
  StepWatch dut;
  dut.Add(At(0), 0);
  dut.Add(At(4), 1);
  dut.Add(At(8), 2);
  dut.Add(At(20), 3);
  dut.Add(At(24), 4);
  EXPECT_EQ(dut.overruns(), 2);
  EXPECT_EQ(dut.simulated(), milliseconds(16));
}

TEST(StepWatch, DoesNotTakeALostMessageForAnOverrun) {
  StepWatch dut;
  dut.Add(At(0), 0);
  dut.Add(At(4), 1);
  dut.Add(At(16), 4);
  EXPECT_EQ(dut.overruns(), 0);
  EXPECT_EQ(dut.simulated(), milliseconds(16));
}

TEST(StepWatch, CountsAnOverrunBeforeItKnowsThePeriod) {
  StepWatch dut;
  dut.Add(At(0), 0);
  dut.Add(At(8), 1);
  dut.Add(At(12), 2);
  EXPECT_EQ(dut.period(), milliseconds(4));
  EXPECT_EQ(dut.overruns(), 1);
}

TEST(StepWatch, TakesRoundedTimesForWhatTheyAre) {
  // 300 Hz in whole microseconds: steps of 3333 and 3334 us. After 30000 steps, 100 s.
  StepWatch dut;
  for (int64_t step = 0; step <= 30'000; ++step) {
    dut.Add(TimePoint{std::chrono::microseconds(step * 10'000 / 3)}, step);
  }
  EXPECT_EQ(dut.overruns(), 0);
  EXPECT_NEAR(ToSeconds(dut.period()), 1.0 / 300, 1e-8);
  EXPECT_NEAR(ToSeconds(dut.simulated()), 100, 1e-3);
}

TEST(StepWatch, GoesOnWhenTheSimulatorStartsAgain) {
  StepWatch dut;
  dut.Add(At(0), 0);
  dut.Add(At(4), 1);
  dut.Add(At(3000), 0);
  dut.Add(At(3004), 1);
  EXPECT_EQ(dut.overruns(), 0);
  EXPECT_EQ(dut.simulated(), milliseconds(8));
}

}  // namespace
}  // namespace eod::recorder
