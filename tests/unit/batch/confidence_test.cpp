#include "batch/confidence.h"

#include <cmath>

#include <gtest/gtest.h>

namespace eod::batch {
namespace {

struct Allowance {
  int failures, runs;  // the fewest runs that allow the claim with so many failures
};

// Reliability statement of the domain's ground rules: 80 % success at 80 % confidence.
constexpr Allowance kTable[] = {{0, 8}, {1, 14}, {2, 21}, {3, 27}, {4, 33}};

TEST(Confidence, EightyPercentAtEightyIsAllowedFromTheTablesRunsOn) {
  for (const auto& [failures, runs] : kTable) {
    EXPECT_TRUE(AllowsClaim(runs - failures, runs)) << failures << " of " << runs;
    EXPECT_FALSE(AllowsClaim(runs - 1 - failures, runs - 1)) << failures << " of " << runs - 1;
  }
}

TEST(Confidence, WithoutAFailureItIsARootOfTheDoubt) {
  // p^n = 1 - confidence.
  for (const int runs : {1, 8, 100, 1000}) {
    EXPECT_NEAR(LowerBound(runs, runs, 0.8), std::pow(0.2, 1.0 / runs), 1e-12);
    EXPECT_NEAR(LowerBound(runs, runs, 0.95), std::pow(0.05, 1.0 / runs), 1e-12);
  }
}

TEST(Confidence, OfOneSuccessItIsWhatMakesAnySuccessSoUnlikely) {
  // 1 - (1 - p)^n = 1 - confidence.
  EXPECT_NEAR(LowerBound(1, 10, 0.8), 1 - std::pow(0.8, 0.1), 1e-12);
}

TEST(Confidence, WithoutASuccessNothingIsClaimed) {
  EXPECT_EQ(LowerBound(0, 0, 0.8), 0);
  EXPECT_EQ(LowerBound(0, 50, 0.8), 0);
  EXPECT_FALSE(AllowsClaim(0, 0));
}

TEST(Confidence, GrowsWithRunsTowardTheRate) {
  double before = 0;
  for (int runs = 10; runs <= 10000; runs *= 10) {
    const double bound = LowerBound(runs * 9 / 10, runs, 0.8);
    EXPECT_GT(bound, before);
    EXPECT_LT(bound, 0.9);
    before = bound;
  }
  EXPECT_NEAR(before, 0.9, 0.01);
}

}  // namespace
}  // namespace eod::batch
