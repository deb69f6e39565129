#include "sim/plume/explosion.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/plume/smoking_fire.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

class ExplosionTest : public ::testing::Test {
 protected:
  void Ignite(bool robot_destroyed = false) { dut_.Ignite({2, 3, 0}, 17, robot_destroyed); }
  void RunTo(double seconds) {
    for (; time_ + kStep / 2 < seconds; time_ += kStep) dut_.Step(kStep);
  }
  double Flame() const {
    double flame = 0;
    for (const PlumeQuad& quad : dut_.quads()) flame += static_cast<double>(1 - quad.cover);
    return flame;
  }

  Explosion dut_{TheExplosion()};
  double time_ = 0;
};

TEST_F(ExplosionTest, NothingIsSeenBeforeIgnition) {
  RunTo(1);
  EXPECT_TRUE(dut_.quads().empty());
  EXPECT_EQ(dut_.effects(), PictureEffects{});
}

TEST_F(ExplosionTest, FlashesForTwoPicturesOfTwentyFiveASecond) {
  Ignite();
  EXPECT_EQ(dut_.effects().flash, 1);
  RunTo(0.039);
  EXPECT_GT(dut_.effects().flash, 0.8F) << "the first picture is white";
  RunTo(0.060);
  EXPECT_GT(dut_.effects().flash, 0.5F) << "the second one pales";
  RunTo(0.084);
  EXPECT_EQ(dut_.effects().flash, 0);
}

TEST_F(ExplosionTest, BurnsForItsFireballThenSmokesUntilItIsGone) {
  Ignite();
  RunTo(0.1);
  EXPECT_GT(Flame(), 10);
  RunTo(TheExplosion().fireball + 2 * kStep);
  EXPECT_EQ(Flame(), 0);
  EXPECT_GT(dut_.quads().size(), 15U);
  RunTo(0.8 * TheExplosion().smoke);
  EXPECT_FALSE(dut_.quads().empty());
  RunTo(TheExplosion().smoke + kStep);
  EXPECT_TRUE(dut_.quads().empty());
  EXPECT_EQ(dut_.effects(), PictureEffects{});
}

TEST_F(ExplosionTest, HasAtMostItsQuadsInEveryStep) {
  Ignite();
  for (int step = 0; step < 2200; ++step) {
    dut_.Step(kStep);
    ASSERT_LE(dut_.quads().size(), 32U);
  }
}

TEST_F(ExplosionTest, ShakesTheCamerasLessAndLess) {
  Ignite();
  EXPECT_FLOAT_EQ(dut_.effects().shake, static_cast<float>(TheExplosion().shake));
  float before = 1;
  uint32_t seed = 0;
  for (int step = 0; step < 100; ++step) {
    dut_.Step(kStep);
    EXPECT_LT(dut_.effects().shake, before);
    EXPECT_NE(dut_.effects().seed, seed) << "another direction each step";
    before = dut_.effects().shake;
    seed = dut_.effects().seed;
  }
  RunTo(3);
  EXPECT_EQ(dut_.effects().shake, 0);
}

TEST_F(ExplosionTest, FeedsOfADestroyedRobotGoToNoiseBehindTheFlashUntilReset) {
  Ignite(true);
  RunTo(TheExplosion().flash - kStep);
  EXPECT_EQ(dut_.effects().noise, 0);
  RunTo(TheExplosion().flash + TheExplosion().noise_ramp / 2);
  EXPECT_NEAR(dut_.effects().noise, 0.5, 0.05);
  RunTo(60);
  EXPECT_EQ(dut_.effects().noise, 1);
  const uint32_t seed = dut_.effects().seed;
  RunTo(60.1);
  EXPECT_NE(dut_.effects().seed, seed) << "noise moves";
  dut_.Reset();
  EXPECT_EQ(dut_.effects(), PictureEffects{});
  EXPECT_TRUE(dut_.quads().empty());
}

TEST_F(ExplosionTest, FeedsOfARobotFarAwayGoOn) {
  Ignite(false);
  for (int step = 0; step < 2200; ++step) {
    dut_.Step(kStep);
    ASSERT_EQ(dut_.effects().noise, 0);
  }
}

TEST_F(ExplosionTest, TwoRunsAreTheSameToTheBit) {
  const auto run = [](Explosion& explosion) {
    std::vector<float> seen;
    explosion.Ignite({2, 3, 0}, 99, true);
    for (int step = 0; step < 1000; ++step) {
      explosion.Step(kStep);
      for (const PlumeQuad& quad : explosion.quads()) {
        seen.insert(seen.end(), {quad.p_M.x(), quad.p_M.y(), quad.p_M.z(), quad.half_size,
                                 quad.colour.x(), quad.alpha, quad.angle, quad.cover});
      }
      seen.insert(seen.end(), {explosion.effects().shake, explosion.effects().noise});
      seen.push_back(static_cast<float>(explosion.effects().seed));
    }
    return seen;
  };
  Explosion other(TheExplosion());
  const std::vector<float> first = run(dut_);
  EXPECT_EQ(first, run(other));
  EXPECT_EQ(first, run(dut_)) << "nothing is left of the run before";
}

}  // namespace
}  // namespace eod::sim
