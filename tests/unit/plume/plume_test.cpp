#include "sim/plume/plume.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/unit/plume/smoking_fire.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

TEST(Plume, NeverHasMoreParticlesThanItMay) {
  for (const int count : {1, 5, 16, 32}) {
    Plume dut(count, TheAir());
    dut.Reset(7);
    PlumeSource source = SmokingFire(count);
    source.rate = 1000;  // far more than there is room for
    dut.Light(source);
    for (int step = 0; step < 2500; ++step) {
      dut.Step(kStep);
      ASSERT_LE(dut.alive(), count) << "step " << step;
    }
    EXPECT_EQ(dut.alive(), count) << "as many as it may: they are reborn";
  }
}

TEST(Plume, ParticlesDieOfAgeOrOfBlackness) {
  Plume dut(32, TheAir());
  dut.Reset(3);
  dut.Light(SmokingFire(32));
  for (int step = 0; step < 2500; ++step) {
    dut.Step(kStep);
    for (const PlumeParticle& particle : dut.particles()) {
      if (!particle.is_alive) continue;
      ASSERT_LE(particle.age, particle.life);
      ASSERT_GE(particle.brightness * particle.colour.maxCoeff(), 0.05);
    }
  }
}

TEST(Plume, IsGoneOneLifeAfterTheSourceStops) {
  Plume dut = Burning(32, 4);
  EXPECT_GT(dut.alive(), 20);
  dut.Extinguish();
  Burn(TheExplosion().smoke_puff.life_max + kStep, dut);
  EXPECT_EQ(dut.alive(), 0);
}

TEST(Plume, MeanBrightnessFallsMonotonicallyAfterTheSourceStops) {
  Plume dut = Burning(32, 4);
  dut.Extinguish();
  double before = dut.mean_brightness();
  EXPECT_GT(before, 0.05);
  while (dut.alive() > 0) {
    dut.Step(kStep);
    ASSERT_LT(dut.mean_brightness(), before);
    before = dut.mean_brightness();
  }
  EXPECT_EQ(before, 0);
}

TEST(Plume, ColourGoesFromWhiteOverYellowAndOrangeAndGreyToBlack) {
  Plume dut(1, TheAir());
  dut.Reset(1);
  PlumeSource source = SmokingFire(1);
  source.puff.flame = 0.4;
  dut.Light(source);
  dut.Burst(1);
  dut.Extinguish();
  const auto colour = [&] { return Vector3d(dut.particles()[0].colour); };
  EXPECT_GT(colour().minCoeff(), 0.7) << "white";
  Burn(0.12, dut);
  EXPECT_GT(colour().y(), 0.6) << "yellow";
  EXPECT_LT(colour().z(), 0.4) << "yellow";
  Burn(0.16, dut);
  EXPECT_GT(colour().x(), 1.6 * colour().y()) << "orange";
  Burn(0.14, dut);
  EXPECT_NEAR(colour().x(), colour().z(), 0.06) << "grey";
  EXPECT_GT(colour().x(), 0.15) << "grey";
  double lightest = 1;
  while (dut.alive() > 0) {
    lightest = colour().maxCoeff();
    Burn(kStep, dut);
  }
  EXPECT_LT(lightest, 0.1) << "almost black";
}

TEST(Plume, CentroidRisesAndDriftsWithTheWind) {
  const auto after = [](double seconds, const Vector3d& wind) {
    Plume plume(32, TheAir(wind));
    plume.Reset(5);
    plume.Light(SmokingFire(32));
    plume.Burst(32);
    plume.Extinguish();
    Burn(seconds, plume);
    return plume.centroid();
  };
  double height = 0;
  for (const double seconds : {0.2, 0.5, 1.0, 1.5, 2.0}) {
    const double now = after(seconds, Vector3d::Zero()).z();
    EXPECT_GT(now, height) << seconds << " s";
    height = now;
  }
  // The same particles, born at the speed of the air: they are carried along with all of it.
  const Vector3d wind(1.0, -0.5, 0);
  const Vector3d drift = after(2, wind) - after(2, Vector3d::Zero());
  EXPECT_LT((drift - 2 * wind).norm(), 0.05) << drift.transpose();
}

TEST(Plume, GrowsAndSlowsDown) {
  Plume dut(8, TheAir(Vector3d::Zero()));
  dut.Reset(2);
  dut.Light(SmokingFire(8));
  dut.Burst(8);
  dut.Extinguish();
  for (int step = 0; step < 400; ++step) {
    const std::vector<PlumeParticle> before(dut.particles().begin(), dut.particles().end());
    dut.Step(kStep);
    for (size_t i = 0; i < before.size(); ++i) {
      const PlumeParticle& now = dut.particles()[i];
      ASSERT_GT(now.half_size, before[i].half_size);
      ASSERT_LE(now.v_M.head<2>().norm(), before[i].v_M.head<2>().norm());
    }
  }
}

TEST(Plume, StaysAboveTheGroundOfItsSource) {
  Plume dut = Burning(32, 5);
  for (const PlumeQuad& quad : dut.quads()) EXPECT_GE(quad.p_M.z(), 0.5F * quad.half_size);
}

TEST(Plume, IsBornOnADiscAndNotInAPoint) {
  Plume dut(32, TheAir());
  dut.Reset(9);
  PlumeSource source = SmokingFire(32);
  source.radius = 0.5;
  dut.Light(source);
  dut.Burst(32);
  double farthest = 0;
  for (const PlumeParticle& particle : dut.particles()) {
    const double off = particle.p_M.head<2>().norm();
    EXPECT_LE(off, 0.5);
    farthest = std::max(farthest, off);
  }
  EXPECT_GT(farthest, 0.4);
}

TEST(Plume, SameSeedSameBitsAndAnotherSeedAnotherPlume) {
  const auto run = [](uint32_t seed) {
    const Plume plume = Burning(32, 3, TheAir(), seed);
    std::vector<Eigen::Vector3f> places;
    for (const PlumeQuad& quad : plume.quads()) places.push_back(quad.p_M);
    return places;
  };
  EXPECT_EQ(run(11), run(11));
  EXPECT_NE(run(11), run(12));
}

}  // namespace
}  // namespace eod::sim
