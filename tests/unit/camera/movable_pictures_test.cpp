#include <memory>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/camera/surface_program.h"
#include "tests/unit/camera/fixture_scene.h"
#include "tests/unit/camera/offline_camera.h"
#include "tests/unit/camera/picture_statistics.h"

namespace eod::sim {
namespace {

using Eigen::Translation3d;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr int kWidth = 320;
constexpr int kHeight = 240;

/// A blue cylinder 0.4 m thick and 0.8 m high, as others look that can be pushed about.
MovableObject BlueDrum(double x, double y) {
  MovableObject drum;
  drum.name = "drum";
  drum.X_MO = Translation3d(x, y, 0.4);
  Visual visual;
  visual.shape = Visual::Shape::kCylinder;
  visual.size = {0.2, 0.2, 0.8};
  visual.material.diffuse = {0.01F, 0.03F, 0.9F};
  drum.visuals = {visual};
  return drum;
}

/// Share of a region's light that is blue, beyond what a third would be.
double Blueness(const std::vector<uint8_t>& picture, const Region& region) {
  const RegionStatistics look = Look(picture, kWidth, kHeight, region);
  return look.mean.z() / (3 * look.brightness()) - 1.0 / 3;
}

class MovablePictures : public ::testing::Test {
 protected:
  /// The robot stands at the origin; 2.5 m before its drive camera a metre is 84 px.
  MovablePictures() {
    snapshot_.state = StandingAt(0, 0);
    for (const MovableObject& drum : world_->modules[0].movables) {
      snapshot_.movables.push_back({.X_MO = drum.X_MO});
    }
  }
  static void SetUpTestSuite() {
    robot_ = std::make_unique<RobotModel>(FixtureRobot());
    world_ = std::make_unique<WorldModel>(FixtureWorld());
    world_->modules[0].movables = {BlueDrum(0, 3), BlueDrum(-15, -15)};
    dut_ = std::make_unique<OfflineCamera>(*robot_, *world_, kWidth, kHeight);
  }
  static void TearDownTestSuite() {
    dut_.reset();
    world_.reset();
    robot_.reset();
  }
  std::vector<uint8_t> Take() { return dut_->Take(snapshot_, "drive"); }

  static constexpr Region kAhead{152, 110, 168, 140};
  static constexpr Region kLeft{68, 110, 84, 140};  // 1 m to the left
  static inline std::unique_ptr<RobotModel> robot_;
  static inline std::unique_ptr<WorldModel> world_;
  static inline std::unique_ptr<OfflineCamera> dut_;
  SceneSnapshot snapshot_;
};

TEST_F(MovablePictures, AreDrawnWhereTheyAre) {
  const auto before = Take();
  EXPECT_GT(Blueness(before, kAhead), 0.2);
  EXPECT_LT(Blueness(before, kLeft), 0.1);
  snapshot_.movables[0].X_MO = Translation3d(-1, 3, 0.4);
  const auto after = Take();
  EXPECT_LT(Blueness(after, kAhead), 0.1);
  EXPECT_GT(Blueness(after, kLeft), 0.2);
}

TEST_F(MovablePictures, AreTurnedAsTheyAre) {
  // Lying across the view it is 0.8 m wide and only 0.4 m high.
  const Region beside{130, 126, 138, 140};  // 0.3 m to the left
  EXPECT_LT(Blueness(Take(), beside), 0.1);
  snapshot_.movables[0].X_MO =
      Translation3d(0, 3, 0.2) * Eigen::AngleAxisd(1.5707963, Eigen::Vector3d::UnitY());
  EXPECT_GT(Blueness(Take(), beside), 0.2);
}

TEST_F(MovablePictures, AreGoneWhenTheyAreGone) {
  snapshot_.movables[0].is_visible = false;
  EXPECT_LT(Blueness(Take(), kAhead), 0.1);
  snapshot_.movables[0].is_visible = true;
  EXPECT_GT(Blueness(Take(), kAhead), 0.2);
}

TEST_F(MovablePictures, StandAtTheirStartUnlessTold) {
  snapshot_.movables.clear();
  EXPECT_GT(Blueness(Take(), kAhead), 0.2);
}

TEST_F(MovablePictures, TakeTheirShadowsAlong) {
  // The default sun shades ground (-0.4, 0.5) / 0.77 of the height off: a drum that hangs 2.9 m
  // high above (1.5, 0.7) shades (0, 2.6), 11 degrees below the drive camera's horizon.
  const Region ground{145, 155, 175, 162};
  snapshot_.movables[0].X_MO = Translation3d(15, 15, 0.4);
  const double lit = Look(Take(), kWidth, kHeight, ground).brightness();
  snapshot_.movables[0].X_MO =
      Translation3d(1.5, 0.7, 2.9) * Eigen::AngleAxisd(1.5707963, Eigen::Vector3d::UnitY());
  const double shaded = Look(Take(), kWidth, kHeight, ground).brightness();
  EXPECT_LT(shaded, 0.9 * lit);
  snapshot_.movables[0].is_visible = false;
  EXPECT_NEAR(Look(Take(), kWidth, kHeight, ground).brightness(), lit, 1);
}

TEST_F(MovablePictures, TooManyAreAnErrorOfOneLine) {
  WorldModel world = FixtureWorld();
  world.modules[0].movables.assign(kMaxBones, BlueDrum(0, 0));
  EXPECT_THAT([&] { OfflineCamera(*robot_, world, kWidth, kHeight).Take({}, "drive"); },
              ThrowsMessage<std::runtime_error>(fmt::format(
                  "fixture_world.sdf: module flat: {} movable objects, cameras can show {}",
                  kMaxBones, kMaxBones - 1)));
}

TEST_F(MovablePictures, UnknownTextureNamesTheOwner) {
  WorldModel world = FixtureWorld();
  world.modules[0].movables = {BlueDrum(0, 0)};
  world.modules[0].movables[0].visuals[0].material.texture = "marble";
  OfflineCamera camera(*robot_, world, kWidth, kHeight);
  EXPECT_THAT([&] { camera.Take(snapshot_, "drive"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("drum: ")));
}

}  // namespace
}  // namespace eod::sim
