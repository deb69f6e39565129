
#include <gtest/gtest.h>

#include "sim/camera/effects_pass.h"
#include "sim/camera/jpeg_encoder.h"
#include "sim/plume/explosion.h"
#include "sim/rules/rules.h"
#include "tests/unit/camera/fixture_camera.h"
#include "tests/unit/camera/picture_statistics.h"

namespace eod::sim {
namespace {

constexpr Region kWhole{0, 0, kWidth, kHeight};
constexpr Region kCentre{150, 110, 170, 130};

class ExplosionPictures : public FixtureCamera {
 protected:
  /// Facing west on the meadow.
  static SceneSnapshot OnTheMeadow() {
    SceneSnapshot snapshot;
    snapshot.state = StandingAt(-10, -10, 1.5708);
    return snapshot;
  }
  /// A puff 3 m before the drive camera and as high.
  static SceneSnapshot WithPuff(const Eigen::Vector3f& colour, float cover) {
    SceneSnapshot snapshot = OnTheMeadow();
    snapshot.quads = {{.p_M = {-13.48F, -10, 0.4F},
                       .half_size = 0.8F,
                       .colour = colour,
                       .alpha = 0.8F,
                       .cover = cover}};
    return snapshot;
  }
  static RegionStatistics LookAt(const SceneSnapshot& snapshot, const Region& region) {
    return Look(dut_->Take(snapshot, "drive"), kWidth, kHeight, region);
  }
};

TEST_F(ExplosionPictures, FlameAddsItsLightAndSmokeHidesWhatIsBehind) {
  const RegionStatistics clear = LookAt(OnTheMeadow(), kCentre);
  const RegionStatistics flame = LookAt(WithPuff({0.5F, 0.1F, 0.01F}, 0), kCentre);
  EXPECT_GT(flame.mean.x(), clear.mean.x() + 40);
  EXPECT_GE(flame.mean.y(), clear.mean.y());
  const RegionStatistics smoke = LookAt(WithPuff({0.05F, 0.05F, 0.05F}, 1), kCentre);
  EXPECT_LT(smoke.brightness(), 0.75 * clear.brightness());
  EXPECT_NEAR(smoke.mean.x(), smoke.mean.z(), 40) << "grey";
}

TEST_F(ExplosionPictures, PlumeLeavesTheRestOfThePictureAlone) {
  const Region aside{0, 60, 60, 180};
  const RegionStatistics clear = LookAt(OnTheMeadow(), aside);
  const RegionStatistics beside = LookAt(WithPuff({0.05F, 0.05F, 0.05F}, 1), aside);
  EXPECT_EQ(beside.mean, clear.mean);
}

TEST_F(ExplosionPictures, WhatStandsBeforeThePlumeHidesIt) {
  // The wall's face at y = 6 stands between the camera and a puff 2 m behind it.
  SceneSnapshot snapshot;
  snapshot.state = StandingAt(0, 3);
  const RegionStatistics wall = LookAt(snapshot, kCentre);
  snapshot.quads = {{.p_M = {0, 8.5F, 0.5F}, .half_size = 0.8F, .alpha = 1, .cover = 1}};
  EXPECT_EQ(LookAt(snapshot, kCentre).mean, wall.mean);
  snapshot.quads[0].p_M.y() = 5;
  EXPECT_LT(LookAt(snapshot, kCentre).brightness(), 0.7 * wall.brightness());
}

TEST_F(ExplosionPictures, DrawsAPlumeByOneCall) {
  dut_->Take(OnTheMeadow(), "drive");
  const DrawCounters clear = dut_->counters();
  Explosion explosion(LoadRules(EOD_DATA_DIR "/sim/rules/eod_rules.toml").explosion);
  explosion.Ignite({-15, -10, 0}, 4, false);
  for (int step = 0; step < 250; ++step) explosion.Step(0.004);
  SceneSnapshot snapshot = OnTheMeadow();
  snapshot.quads.assign(explosion.quads().begin(), explosion.quads().end());
  dut_->Take(snapshot, "drive");
  EXPECT_EQ(dut_->counters().draw_calls, clear.draw_calls + 1);
  EXPECT_LE(dut_->counters().triangles, clear.triangles + 64) << "two triangles a quad";
  EXPECT_GT(dut_->counters().triangles, clear.triangles + 20);
}

TEST_F(ExplosionPictures, FlashWhitensTheWholePicture) {
  SceneSnapshot snapshot = OnTheMeadow();
  const double before = LookAt(snapshot, kWhole).brightness();
  snapshot.effects.flash = 0.5F;
  EXPECT_NEAR(LookAt(snapshot, kWhole).brightness(), (before + 255) / 2, 3);
  snapshot.effects.flash = 1;
  EXPECT_EQ(LookAt(snapshot, kWhole).brightness(), 255);
}

TEST_F(ExplosionPictures, NoiseReplacesThePictureAndMoves) {
  SceneSnapshot snapshot = OnTheMeadow();
  snapshot.effects = {.noise = 1, .seed = 1};
  const std::vector<uint8_t> first = dut_->Take(snapshot, "drive");
  const RegionStatistics noise = Look(first, kWidth, kHeight, kWhole);
  EXPECT_EQ(noise.mean.x(), noise.mean.z()) << "grey";
  EXPECT_GT(noise.deviation.x(), 15);
  EXPECT_NEAR(Look(first, kWidth, kHeight, {0, 0, kWidth, 60}).brightness(),
              Look(first, kWidth, kHeight, {0, 180, kWidth, 240}).brightness(), 25)
      << "neither sky nor ground is left";
  EXPECT_EQ(dut_->Take(snapshot, "drive"), first);
  snapshot.effects.seed = 2;
  EXPECT_NE(dut_->Take(snapshot, "drive"), first);
}

TEST_F(ExplosionPictures, NoiseFitsADatagramAtItsQuality) {
  OfflineCamera camera(*robot_, *world_, 640, 480);
  JpegEncoder encoder(640, 480, 80);
  SceneSnapshot snapshot = OnTheMeadow();
  for (uint32_t seed = 1; seed <= 5; ++seed) {
    snapshot.effects = {.noise = 1, .seed = seed};
    EXPECT_FALSE(encoder.Encode(camera.Take(snapshot, "drive")).empty());
    EXPECT_EQ(encoder.last_quality(), 80) << "compressed once";
  }
}

TEST_F(ExplosionPictures, ShakingTurnsTheViewByNoMoreThanItsAmplitude) {
  const float shake = 0.05F;
  Eigen::Vector3d before = Eigen::Vector3d::UnitY();
  for (uint32_t seed = 1; seed < 50; ++seed) {
    const Eigen::Vector3d ahead = ShakeOf({.shake = shake, .seed = seed}).linear().col(1);
    EXPECT_LT(std::acos(ahead.y()), 1.5 * static_cast<double>(shake));
    EXPECT_NE(ahead, before);
    before = ahead;
  }
  EXPECT_TRUE(ShakeOf({.seed = 3}).linear().isIdentity(0));
}

TEST_F(ExplosionPictures, WithoutEffectsThePictureIsAsItWas) {
  const std::vector<uint8_t> before = dut_->Take(OnTheMeadow(), "drive");
  SceneSnapshot snapshot = WithPuff({1, 1, 1}, 0);
  snapshot.effects = {.flash = 0.5F, .shake = 0.05F, .noise = 0.5F, .seed = 9};
  EXPECT_NE(dut_->Take(snapshot, "drive"), before);
  EXPECT_EQ(dut_->Take(OnTheMeadow(), "drive"), before);
}

}  // namespace
}  // namespace eod::sim
