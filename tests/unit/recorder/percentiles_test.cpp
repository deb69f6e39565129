#include "recorder/percentiles.h"

#include <numeric>

#include <gtest/gtest.h>

namespace eod::recorder {
namespace {

TEST(Percentiles, AreEmptyWithoutSamples) {
  const Percentiles dut = ComputePercentiles({});
  EXPECT_EQ(dut.n, 0U);
  EXPECT_FALSE(dut.p50.has_value());
  EXPECT_FALSE(dut.p99.has_value());
}

TEST(Percentiles, OfOneSampleAreThatSample) {
  const Percentiles dut = ComputePercentiles({4.5});
  EXPECT_EQ(dut.n, 1U);
  EXPECT_EQ(dut.p50, 4.5);
  EXPECT_EQ(dut.p99, 4.5);
}

TEST(Percentiles, UseTheNearestRankWhateverTheOrder) {
  // 1..200 backwards: rank ceil(0.5 * 200) = 100, ceil(0.99 * 200) = 198.
  std::vector<double> samples(200);
  std::iota(samples.rbegin(), samples.rend(), 1.0);
  const Percentiles dut = ComputePercentiles(samples);
  EXPECT_EQ(dut.p50, 100.0);
  EXPECT_EQ(dut.p99, 198.0);
}

TEST(Percentiles, P99OfFewSamplesIsTheWorstOne) {
  // Rank ceil(0.99 * 3) = 3, ceil(0.5 * 3) = 2.
  const Percentiles dut = ComputePercentiles({9.0, 1.0, 2.0});
  EXPECT_EQ(dut.p50, 2.0);
  EXPECT_EQ(dut.p99, 9.0);
}

}  // namespace
}  // namespace eod::recorder
