#include "sim/scenario/variation.h"

#include <cmath>

#include <gtest/gtest.h>

namespace eod::sim {
namespace {

Scenario Spread() {
  Scenario scenario;
  scenario.seed = 7;
  scenario.start.position = Eigen::Vector3d(1, 2, 0);
  scenario.start.spread = Eigen::Vector3d(0.15, 0.3, 0.05);
  Placement charge;
  charge.object = "charge_m";
  charge.spread = Eigen::Vector3d(0.1, 0.1, 0);
  scenario.places.push_back(charge);
  scenario.lights = {Weather::Light::kDay, Weather::Light::kNight};
  return scenario;
}

TEST(Vary, RepetitionZeroIsWhatTheFileSays) {
  const Scenario dut = Vary(Spread(), 0);
  EXPECT_EQ(dut.start.shift, Eigen::Vector3d::Zero());
  EXPECT_EQ(dut.places[0].shift, Eigen::Vector3d::Zero());
  EXPECT_EQ(dut.start.spread, Eigen::Vector3d::Zero());
  EXPECT_EQ(dut.places[0].spread, Eigen::Vector3d::Zero());
  EXPECT_EQ(dut.start.position, Spread().start.position);
  EXPECT_EQ(dut.weather.light, Weather::Light::kDay);
  EXPECT_EQ(dut.seed, 7);
}

TEST(Vary, SameRepetitionIsTheSameToTheBitAndAnotherOneIsNot) {
  const Scenario once = Vary(Spread(), 3);
  const Scenario again = Vary(Spread(), 3);
  EXPECT_EQ(once.start, again.start);
  EXPECT_EQ(once.places, again.places);
  EXPECT_EQ(once.seed, again.seed);
  const Scenario other = Vary(Spread(), 4);
  EXPECT_NE(once.start, other.start);
  EXPECT_NE(once.places, other.places);
  EXPECT_NE(once.seed, other.seed);
  Scenario seeded = Spread();
  seeded.seed = 8;
  EXPECT_NE(once.start, Vary(seeded, 3).start);
}

// SplitMix64 begun at its first number of `seed`, exclusive or `repetition`: the seed, the light,
// and x of the start. Worked out in Python's whole numbers.
TEST(Vary, GoldenDrawOfTheFirstRepetition) {
  const Scenario dut = Vary(Spread(), 1);
  EXPECT_EQ(static_cast<uint64_t>(dut.seed), 4414019431610648415U);
  EXPECT_EQ(dut.start.shift.x(), -0.49248282716265246 * 0.15);
}

TEST(Vary, DrawsFillTheirRangeEvenly) {
  constexpr int kRepetitions = 4000;
  const Eigen::Vector3d spread = Spread().start.spread;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();
  int nights = 0;
  for (uint64_t repetition = 1; repetition <= kRepetitions; ++repetition) {
    const Scenario dut = Vary(Spread(), repetition);
    ASSERT_TRUE((dut.start.shift.cwiseAbs().array() <= spread.array()).all());
    ASSERT_EQ(dut.places[0].shift.z(), 0);
    const Eigen::Vector3d share = dut.start.shift.cwiseQuotient(spread);
    sum += share;
    squares += share.cwiseProduct(share);
    nights += dut.weather.light == Weather::Light::kNight ? 1 : 0;
  }
  // Evenly within -1 .. 1: mean 0, variance 1/3. Bounds of five standard errors.
  const double error = 5 / std::sqrt(3.0 * kRepetitions);
  EXPECT_LT((sum / kRepetitions).cwiseAbs().maxCoeff(), error);
  EXPECT_LT((squares / kRepetitions - Eigen::Vector3d::Constant(1.0 / 3)).cwiseAbs().maxCoeff(),
            error);
  EXPECT_NEAR(nights, kRepetitions / 2.0, 5 * std::sqrt(kRepetitions / 4.0));
}

TEST(Vary, OneSpreadDoesNotMoveWhatAnotherDraws) {
  Scenario narrow = Spread();
  narrow.start.spread.setZero();
  EXPECT_EQ(Vary(narrow, 5).places, Vary(Spread(), 5).places);
}

}  // namespace
}  // namespace eod::sim
