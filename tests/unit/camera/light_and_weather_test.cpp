#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "sim/camera/light_probe.h"
#include "sim/camera/lighting.h"
#include "sim/geometry/object_class.h"
#include "tests/unit/camera/conditions.h"
#include "tests/unit/camera/fixture_camera.h"
#include "tests/unit/camera/picture_statistics.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr Region kAhead{80, 200, 240, kHeight};  // grass before the robot

double Brightness(const std::vector<uint8_t>& picture) {
  return Look(picture, kWidth, kHeight, kAhead).brightness();
}

class LightAndWeather : public FixtureCamera {
 protected:
  static std::vector<uint8_t> Take(const std::string& weather, const std::string& lights = "",
                                   double seconds = 0) {
    SceneSnapshot snapshot;
    snapshot.state = StandingAt(0, -15);
    snapshot.weather = ParseWeather(weather);
    snapshot.lights = ParseLights(lights);
    snapshot.time += std::chrono::milliseconds(std::lround(1000 * seconds));
    return dut_->Take(snapshot, "drive");
  }
};

TEST_F(LightAndWeather, GroundIsAsDarkAsTheLightOnItSays) {
  const auto light = [](const char* weather) {
    return static_cast<double>(
        LightingOf(world_->atmosphere, ParseWeather(weather)).OnOpenGround());
  };
  const double day = Brightness(Take("day"));
  // A picture holds square roots of light.
  for (const char* weather : {"dusk", "night"}) {
    const double wanted = std::sqrt(light(weather) / light("day"));
    EXPECT_NEAR(Brightness(Take(weather)) / day / wanted, 1, 0.35) << weather;
  }
}

TEST_F(LightAndWeather, InfraredShowsGreyOnly) {
  const std::vector<uint8_t> picture = Take("night", "infrared");
  for (size_t i = 0; i < picture.size(); i += 4) {
    ASSERT_LE(std::abs(picture[i] - picture[i + 1]), 1);
    ASSERT_LE(std::abs(picture[i] - picture[i + 2]), 1);
  }
}

TEST_F(LightAndWeather, RainFallsWithTimeAlone) {
  const std::vector<uint8_t> first = Take("day,rain=20", "", 1);
  const std::vector<uint8_t> later = Take("day,rain=20", "", 1.2);
  EXPECT_NE(first, later);
  EXPECT_EQ(Take("day,rain=20", "", 1), first);
}

// Koschmieder 1924: 5 % of the contrast are left at the visibility.
TEST(Lighting, FogLeavesFivePercentAtTheVisibility) {
  for (const double visibility : {50.0, 400.0}) {
    const Lighting light = LightingOf({}, {.visibility = visibility});
    EXPECT_NEAR(std::exp(-static_cast<double>(light.fog_density) * visibility), 0.05, 1e-4);
  }
}

TEST(LightProbe, CeilingHidesTheSky) {
  WorldModel world = FixtureWorld();
  ModuleModel& module = world.modules[0];
  module.class_bit = 1;
  const uint32_t mask = module.class_bit | kBumpProxy;
  const Vector3d a(-4, -4, 3), b(-4, 4, 3), c(4, 4, 3), d(4, -4, 3);
  // Clockwise from above: it looks down.
  module.triangles = {{.corner = {a, b, c}, .class_mask = mask},
                      {.corner = {a, c, d}, .class_mask = mask}};
  LightProbe dut(module, false);
  const Vector3f up = Vector3f::UnitZ();
  EXPECT_TRUE(dut.IsRoofed(Vector3f::Zero(), up));
  EXPECT_LT(dut.At(Vector3f::Zero(), up).sky, 0.8F);
  EXPECT_FALSE(dut.IsRoofed({0, -15, 0}, up));
  EXPECT_EQ(dut.At({0, -15, 0}, up).sky, 1);
}

}  // namespace

/// The shipped robot has lamps.
TEST(Headlights, BrightenWhatIsAheadAndNotWhatIsBehind) {
  const RobotModel robot = LoadRobot(EOD_DATA_DIR "/sim/robots/eod_robot.sdf");
  const WorldModel world = FixtureWorld();
  OfflineCamera dut(robot, world, kWidth, kHeight);
  SceneSnapshot snapshot;
  snapshot.weather = ParseWeather("night");
  snapshot.state = HomeState(robot);
  snapshot.state.position = Vector3d(0, -15, 0);
  const auto look = [&](const char* camera, const char* lights) {
    snapshot.lights = ParseLights(lights);
    return Look(dut.Take(snapshot, camera), kWidth, kHeight, {0, 120, kWidth, kHeight})
        .brightness();
  };
  EXPECT_GT(look("drive", "drive"), 2 * look("drive", ""));
  EXPECT_NEAR(look("rear", "drive"), look("rear", ""), 2);
}

}  // namespace eod::sim
