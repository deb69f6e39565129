#include "tests/unit/plume/plume_mask.h"

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/plume/smoking_fire.h"

namespace eod::sim {
namespace {

constexpr double kCore = 0.6;  // of the half size: there the texture is still half as dense

PlumeQuad At(float x, float z, float half_size) {
  return {.p_M = {x, 0, z}, .half_size = half_size, .alpha = 1};
}

TEST(PlumeMask, MeasuresADiscAndTheOverlapOfTwo) {
  const std::vector<PlumeQuad> one{At(0, 4, 1)};
  const PlumeMask mask(one, 1);
  // pi m^2 in cells of 0.0025 m^2.
  EXPECT_NEAR(static_cast<double>(mask.area()), std::numbers::pi / 0.0025, 40);
  EXPECT_EQ(mask.Likeness(mask), 1);
  const std::vector<PlumeQuad> aside{At(3, 4, 1)};
  EXPECT_EQ(mask.Likeness(PlumeMask(aside, 1)), 0);
}

/// Cells covered in the mean of three seconds, longer than most particles live.
double MeanArea(int count, uint32_t seed) {
  Plume plume = Burning(count, 4, TheAir(), seed);
  size_t sum = 0;
  constexpr int kMoments = 30;
  for (int moment = 0; moment < kMoments; ++moment) {
    Burn(0.1, plume);
    sum += PlumeMask(plume.quads(), kCore).area();
  }
  return static_cast<double>(sum) / kMoments;
}

TEST(PlumeCoverage, GrowsWithTheNumberOfParticles) {
  // Domain, section 7: the paper shows 1, 5, 16 and 32 particles.
  for (const uint32_t seed : {1U, 2U, 3U}) {
    double smaller = 0;
    for (const int count : {1, 5, 16, 32}) {
      const double area = MeanArea(count, seed);
      EXPECT_GT(area, 1.1 * smaller) << count << " particles, seed " << seed;
      smaller = area;
    }
  }
}

TEST(PlumeCoverage, OfThirtyTwoQuadsIsThatOfFiveThousandPoints) {
  // Domain, section 7: intersection over union of at least 0.6. The points are the classic method:
  // the same fire, each particle one cell of the mask.
  for (const uint32_t seed : {1U, 2U, 3U, 4U, 5U}) {
    const PlumeMask quads(Burning(32, 6, TheAir(), seed).quads(), kCore);
    const PlumeMask points(Burning(5000, 6, TheAir(), seed + 100).quads(), 0);
    EXPECT_GE(quads.Likeness(points), 0.6)
        << "seed " << seed << ": " << quads.area() << " and " << points.area() << " cells";
  }
}

}  // namespace
}  // namespace eod::sim
