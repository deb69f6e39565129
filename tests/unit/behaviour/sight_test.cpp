#include "sim/sight.h"

#include <gtest/gtest.h>

#include "tests/unit/behaviour/fixture.h"

namespace eod::sim {
namespace {

constexpr uint32_t kWall = kModuleFlat | kBumpProxy;

/// A camera at the origin of its link, 90 degrees wide and 4:3, that looks along +Y.
struct Scene {
  CameraSpec camera{.name = "mast",
                    .link = 0,
                    .horizontal_fov = 90 * kDegree,
                    .near = 0.06,
                    .width = 640,
                    .height = 480};
  std::vector<Eigen::Isometry3d> X_ML{Eigen::Isometry3d::Identity()};
  AnalyticWorld world;
  CastMemory memory;

  bool Shows(const Eigen::Vector3d& p_M, double distance = 10, std::string_view object = "") {
    return Sees(camera, X_ML, world, {.p_M = p_M, .distance = distance, .object = object}, memory);
  }
  void AddBoard(const std::string& name, double y) {
    Eigen::Isometry3d X_MB = Eigen::Isometry3d::Identity();
    X_MB.translation().y() = y;
    world.AddBox(name, kWall, X_MB, Eigen::Vector3d(1, 0.1, 1));
  }
};

TEST(Sight, EndsAtTheEdgesOfThePicture) {
  Scene dut;
  // At 4 m the picture is 8 m wide and 6 m high.
  EXPECT_TRUE(dut.Shows({3.99, 4, 0}));
  EXPECT_FALSE(dut.Shows({4.01, 4, 0}));
  EXPECT_TRUE(dut.Shows({0, 4, -2.99}));
  EXPECT_FALSE(dut.Shows({0, 4, -3.01}));
  EXPECT_FALSE(dut.Shows({0, -4, 0}));
}

TEST(Sight, GoesWithTheCamerasLink) {
  Scene dut;
  dut.X_ML[0].linear() = ToRotation({.heading = 90 * kDegree});
  EXPECT_TRUE(dut.Shows({-4, 0, 0}));
  EXPECT_FALSE(dut.Shows({0, 4, 0}));
}

TEST(Sight, EndsAtItsDistance) {
  Scene dut;
  EXPECT_TRUE(dut.Shows({0, 4.99, 0}, 5));
  EXPECT_FALSE(dut.Shows({0, 5.01, 0}, 5));
}

TEST(Sight, EndsAtWhatStandsBetween) {
  Scene dut;
  dut.AddBoard("board", 2);
  EXPECT_FALSE(dut.Shows({0, 4, 0}));
  EXPECT_TRUE(dut.Shows({2, 4, 0}));  // past its edge: at 2 m it is 1 m from the middle
}

TEST(Sight, AnObjectsOwnSurfaceHidesAPointOnItButNotItself) {
  Scene dut;
  dut.AddBoard("board", 4);
  EXPECT_TRUE(dut.Shows({0, 4, 0}, 10, "board"));     // its middle
  EXPECT_FALSE(dut.Shows({0, 4.05, 0}));              // a point on its back
  EXPECT_TRUE(dut.Shows({0, 3.95, 0}));               // a point on its front
  EXPECT_FALSE(dut.Shows({0, 4, 0}, 10, "another"));  // what it hides
}

}  // namespace
}  // namespace eod::sim
