#include "sim/camera/scene_renderer.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/camera/isector_overlay.h"
#include "tests/unit/camera/fixture_camera.h"
#include "tests/unit/camera/picture_statistics.h"

namespace eod::sim {
namespace {

using Eigen::Translation3d;
using Eigen::Vector3d;
using Eigen::Vector3f;
using ::testing::HasSubstr;
using ::testing::Property;
using ::testing::ThrowsMessage;

constexpr Region kTop{0, 0, kWidth, 40};
constexpr Region kBottom{0, 200, kWidth, kHeight};
constexpr Region kCentre{120, 90, 200, 120};
constexpr double kDegree = std::numbers::pi / 180;

class SceneRendererTest : public FixtureCamera {
 protected:
  static std::vector<uint8_t> Take(const SceneSnapshot& snapshot,
                                   const std::string& camera = "drive") {
    return dut_->Take(snapshot, camera);
  }

  /// The drive camera's picture of another world.
  static std::vector<uint8_t> TakeIn(const WorldModel& world, const SceneSnapshot& snapshot) {
    OfflineCamera camera(*robot_, world, kWidth, kHeight);
    return camera.Take(snapshot, "drive");
  }

  static SceneSnapshot At(double x, double y, double heading_deg = 0) {
    SceneSnapshot snapshot;
    snapshot.state = StandingAt(x, y, heading_deg * kDegree);
    return snapshot;
  }

  static RegionStatistics LookAt(const std::vector<uint8_t>& picture, const Region& region) {
    return Look(picture, kWidth, kHeight, region);
  }
};

TEST_F(SceneRendererTest, DrawsTheSameSnapshotToTheSameBytes) {
  const SceneSnapshot snapshot = At(0, 0);
  const auto first = Take(snapshot);
  Take(At(1, 2, 30));
  EXPECT_EQ(Take(snapshot), first);
  // A second context paints its own textures: they must be the same as well.
  EXPECT_EQ(TakeIn(*world_, snapshot), first);
}

TEST_F(SceneRendererTest, ShowsSkyAboveAndGrassBelowTheHorizon) {
  // At (-10, -10) facing west the yard and the wall are out of sight: meadow and sky only.
  const auto picture = Take(At(-10, -10, 90));
  const RegionStatistics sky = LookAt(picture, kTop);
  const RegionStatistics ground = LookAt(picture, kBottom);
  EXPECT_GT(sky.mean.z(), sky.mean.x()) << "sky is bluer than red";
  EXPECT_GT(sky.brightness(), 150);
  EXPECT_GT(ground.mean.y(), ground.mean.x()) << "grass is greener than red";
  EXPECT_GT(ground.mean.y(), ground.mean.z());
  EXPECT_GT(ground.deviation.y(), 5) << "blades, not a flat colour";
}

TEST_F(SceneRendererTest, BrickWallFillsTheCentreOneMetreAhead) {
  // The drive camera stands 0.48 m before the origin; the wall's face at y = 6: 1 m from y = 4.52.
  const RegionStatistics wall = LookAt(Take(At(0, 4.52)), kCentre);
  EXPECT_GT(wall.mean.x(), wall.mean.y() + 20) << "brick is red";
  EXPECT_GT(wall.deviation.x(), 8) << "bricks and joints, not a flat colour";
}

TEST_F(SceneRendererTest, LooksAlongTheHeading) {
  const RegionStatistics north = LookAt(Take(At(0, 3)), kCentre);
  const RegionStatistics south = LookAt(Take(At(0, 3, 180)), kCentre);
  EXPECT_GT(north.mean.x() - north.mean.z(), 30) << "the wall";
  EXPECT_LT(south.mean.x() - south.mean.z(), 30) << "no wall";
}

TEST_F(SceneRendererTest, ShadowDarkensTheGround) {
  // The default sun stands at (0.4, -0.5, 0.77): a slab 3 m above the ground shades what lies
  // (-0.4, 0.5) / 0.77 * 3 = (-1.56, 1.95) m off. Seen from the south the shade is straight ahead.
  const SceneSnapshot snapshot = At(-1.56, -1.0);
  const Region ground{100, 170, 220, 200};  // 13 to 21 degrees down: 1.1 to 1.8 m ahead
  const RegionStatistics lit = LookAt(Take(snapshot), ground);
  WorldObject slab = GroundBox("slab", 0, -0.8, {3, 3, 0.1}, {});
  slab.X_MO = Translation3d(0, -1.0, 3);
  WorldModel world = *world_;
  world.modules[0].objects.push_back(slab);
  const RegionStatistics shaded = LookAt(TakeIn(world, snapshot), ground);
  EXPECT_LT(shaded.brightness(), 0.75 * lit.brightness());
  EXPECT_GT(shaded.brightness(), 0.2 * lit.brightness()) << "the sky still lights it";
}

TEST_F(SceneRendererTest, FogPalesWhatIsFarAway) {
  // A black board 30 m wide, 10 and then 100 m ahead. Fog of 0.01/m leaves exp(-0.1) = 90 % and
  // exp(-1) = 37 % of its own colour.
  WorldModel world = *world_;
  world.atmosphere.fog_density = 0.01F;
  const auto board_at = [&](double distance) {
    Material black;
    black.diffuse = Vector3f::Zero();
    world.modules[0].objects = {GroundBox("board", 0, distance + 0.48, {30, 0.1, 20}, black)};
    return LookAt(TakeIn(world, At(0, 0)), Region{140, 95, 180, 110}).brightness();
  };
  const double fog = 255 * static_cast<double>(world.atmosphere.fog_colour.mean());
  EXPECT_NEAR(board_at(10), 0.10 * fog, 12);
  EXPECT_NEAR(board_at(100), 0.63 * fog, 12);
}

TEST_F(SceneRendererTest, MastPanTurnsTheView) {
  // Panned left by 60 degrees the wall (at most atan(3 / 6.2) = 26 degrees off) leaves the picture.
  SceneSnapshot snapshot = At(0, 0);
  const RegionStatistics ahead = LookAt(Take(snapshot, "mast"), kCentre);
  snapshot.state.joint[kCameraPan] = 60 * kDegree;
  const RegionStatistics aside = LookAt(Take(snapshot, "mast"), kCentre);
  EXPECT_GT(ahead.mean.x() - ahead.mean.y(), 20) << "the wall";
  EXPECT_LT(aside.mean.x() - aside.mean.y(), 10) << "grass and trees";
}

TEST_F(SceneRendererTest, MastTiltRaisesTheView) {
  SceneSnapshot snapshot = At(-10, -10, 90);
  snapshot.state.joint[kCameraTilt] = 60 * kDegree;
  const RegionStatistics sky = LookAt(Take(snapshot, "mast"), kBottom);
  EXPECT_GT(sky.mean.z(), sky.mean.x());
}

TEST_F(SceneRendererTest, ShowsTheRobotsOwnPartsInTheView) {
  // The fixture's orange boom lies to the right of the drive camera, below the horizon.
  const RegionStatistics boom = LookAt(Take(At(-10, -10, 90)), Region{290, 200, 320, 225});
  EXPECT_GT(boom.mean.x(), boom.mean.z() + 60);
}

TEST_F(SceneRendererTest, DrawsIsectorsByWhatTheyMet) {
  // Three lines across the view, 2 m ahead of the origin and 0.3 to 0.5 m above the ground.
  SceneSnapshot snapshot = At(-10, -10);
  const auto line = [](double z, bool hit, bool contact) {
    return DrawnSegment{.start = {-10.5, -8, z},
                        .end = {-9.5, -8, z},
                        .hit = hit,
                        .contact = contact,
                        .point = {-9.5, -8, z}};
  };
  EXPECT_EQ(CountColour(Take(snapshot), kContactColour), 0);
  snapshot.segments = {line(0.3, false, false), line(0.4, true, false), line(0.5, true, true)};
  const auto picture = Take(snapshot);
  // 1 m at 1.52 m fills 1 / (2 * 1.52 * tan(0.65)) = 43 % of 320 px: 138 px, at least one high.
  for (const uint8_t* colour : {kFreeColour, kHitColour, kContactColour}) {
    EXPECT_GT(CountColour(picture, colour), 130);
  }
}

TEST_F(SceneRendererTest, IsectorsEndAtTheirHitsWithACross) {
  SceneSnapshot snapshot = At(-10, -10);
  DrawnSegment segment{.start = {-10.5, -8, 0.4}, .end = {-9.5, -8, 0.4}};
  snapshot.segments = {segment};
  const int whole = CountColour(Take(snapshot), kFreeColour);
  segment.hit = true;
  segment.point = {-10.4, -8, 0.4};
  snapshot.segments = {segment};
  const auto picture = Take(snapshot);
  // A tenth of the line, and a cross of two diagonals of 12 px: 14 + 2 x 17 px of 138, of one
  // width.
  EXPECT_GT(CountColour(picture, kHitColour), 0);
  EXPECT_LT(CountColour(picture, kHitColour), whole / 2);
  EXPECT_EQ(CountColour(picture, kFreeColour), 0);
  // The cross stands 0.4 m left of the middle, 55 px; 5 px off the line it still shows.
  const RegionStatistics cross = LookAt(picture, Region{97, 100, 113, 116});
  EXPECT_GT(cross.deviation.maxCoeff(), 5);
}

TEST_F(SceneRendererTest, IsectorsBehindTheCameraAreNotDrawn) {
  SceneSnapshot snapshot = At(0, 0);
  snapshot.segments = {{.start = {-1, -3, 0.4},
                        .end = {1, -3, 0.4},
                        .hit = true,
                        .contact = true,
                        .point = {0, -3, 0.4}}};
  EXPECT_EQ(CountColour(Take(snapshot), kContactColour), 0);
}

TEST_F(SceneRendererTest, ShowsAModuleThatIsNotThereAsMeadow) {
  SceneSnapshot snapshot = At(0, 4.52);
  snapshot.module = 4;
  const RegionStatistics ground = LookAt(Take(snapshot), kBottom);
  EXPECT_GT(ground.mean.y(), ground.mean.x());
}

TEST_F(SceneRendererTest, LeavesOutWhatIsBehindTheCamera) {
  Take(At(0, 0));
  const int with_wall = dut_->counters().draw_calls;
  // From 54 m beyond the wall, facing north, the whole yard lies behind, and out of the sun's map
  // too.
  Take(At(0, 60));
  EXPECT_LT(dut_->counters().draw_calls, with_wall);
}

TEST_F(SceneRendererTest, UnknownCameraNamesTheCamerasThereAre) {
  EXPECT_THAT([&] { FindCamera(*robot_, "rear"); },
              ThrowsMessage<std::runtime_error>(
                  "fixture_robot.sdf: no camera \"rear\"; there are: drive, mast"));
}

TEST_F(SceneRendererTest, UnknownTextureNamesTheOwnerAndTheTextures) {
  WorldModel world = *world_;
  world.modules[0].objects[2].visuals[0].material.texture = "marble";
  EXPECT_THAT([&] { TakeIn(world, At(0, 0)); },
              ThrowsMessage<std::runtime_error>(
                  AllOf(HasSubstr("wall: "), HasSubstr("\"marble\""), HasSubstr("grass"))));
}

TEST(TrainingGroundPictures, StayWithinTheTriangleAndDrawBudget) {
  const RobotModel robot = LoadRobot(EOD_DATA_DIR "/sim/robots/eod_robot.sdf");
  const WorldModel world = LoadWorld(EOD_DATA_DIR "/sim/worlds/training_ground.sdf");
  OfflineCamera dut(robot, world, 160, 120);
  SceneSnapshot snapshot;
  snapshot.state = HomeState(robot);
  for (const ModuleModel& module : world.modules) {
    snapshot.module = module.id;
    for (const double heading_deg : {0, 60, 120, 180, 240, 300}) {
      for (const Vector3d& place : {Vector3d(0, 0, 0), Vector3d(0, -30, 0), Vector3d(-20, 15, 0)}) {
        snapshot.state.position = place;
        snapshot.state.attitude.heading = heading_deg * kDegree;
        for (const char* camera : {"drive", "mast", "gripper", "rear"}) {
          dut.Take(snapshot, camera);
          EXPECT_LE(dut.counters().triangles, 50000)
              << module.name << " " << camera << " at " << place.transpose();
          EXPECT_LE(dut.counters().draw_calls, 250)
              << module.name << " " << camera << " at " << place.transpose();
        }
      }
    }
  }
}

}  // namespace
}  // namespace eod::sim
