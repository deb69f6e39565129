// The training ground as a whole, and its flat module, measured by casting segments.
#include "tests/unit/sim/training_ground.h"

#include <cmath>
#include <map>

namespace eod::sim {
namespace {

using Eigen::Vector3d;
using Met = BuiltModule::Met;

class TrainingGround : public ::testing::Test {
 protected:
  static const WorldModel& Model() { return TrainingGroundModel(); }
  const ModuleModel& flat_ = Model().Module(1);

  Met Look(const Vector3d& start, const Vector3d& direction) {
    static const BuiltModule module(1);
    return module.Look(start, direction);
  }
};

TEST_F(TrainingGround, FlatModuleLiesWhereTheMapSays) {
  EXPECT_EQ(flat_.name, "flat");
  EXPECT_EQ(flat_.class_bit, kModuleFlat);
  EXPECT_EQ(flat_.p_WM, Vector3d(-1000, 1000, 0));
  EXPECT_EQ(flat_.half_size, Eigen::Vector2d(50, 50));
  EXPECT_EQ(flat_.start_attitude, Attitude{});
}

TEST_F(TrainingGround, HasAtLeastEighteenStaticModels) {
  EXPECT_GE(flat_.objects.size(), 18u);
  for (const WorldObject& object : flat_.objects) EXPECT_TRUE(object.is_static) << object.name;
}

TEST_F(TrainingGround, UnknownModuleNamesThoseThatThereAre) {
  try {
    Model().Module(6);
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("has no module 6, only 1 (flat), 2 (slope), 3 (bomb)"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(TrainingGround, GroundIsLevelAllOverTheYard) {
  for (double x = -49; x < 50; x += 7.3) {
    for (double y = -49; y < 50; y += 7.1) {
      const Met met = Look({x, y, 0.02}, -Vector3d::UnitZ());
      // Whatever is met so low is the ground, or something that stands here from the ground up.
      if (met.object == "ground") {
        EXPECT_NEAR(met.range, 0.02, 1e-12);
      }
      EXPECT_GE(met.range, 0) << x << " " << y;
    }
  }
}

TEST_F(TrainingGround, WallStandsFourMetresNorthOfTheStart) {
  for (const double x : {-1.999, 0.0, 1.999}) {
    for (const double z : {0.01, 0.3, 1.199}) {
      const Met met = Look({x, 0, z}, Vector3d::UnitY());
      EXPECT_EQ(met.object, "wall");
      EXPECT_NEAR(met.range, 4.0, 1e-9);
    }
  }
  EXPECT_NE(Look({2.001, 0, 0.3}, Vector3d::UnitY()).object, "wall");
  EXPECT_NE(Look({0, 0, 1.201}, Vector3d::UnitY()).object, "wall");
  EXPECT_NEAR(Look({0, 8, 0.3}, -Vector3d::UnitY()).range, 8 - 4.25, 1e-9);  // 0.25 thick
}

TEST_F(TrainingGround, FirstGateOpensOnePointTwoMetresAcrossTheWayWest) {
  EXPECT_NEAR(Look({-4.0, 1.9, 0.7}, Vector3d::UnitY()).range, 0.6, 1e-9);
  EXPECT_NEAR(Look({-4.0, 1.9, 0.7}, -Vector3d::UnitY()).range, 0.6, 1e-9);
  EXPECT_EQ(Look({-4.0, 1.9, 0.7}, Vector3d::UnitY()).object, "gate_1");
  EXPECT_GT(Look({-4.0, 1.9, 0.1}, Vector3d::UnitZ()).range, 1.5);  // the bar above
}

TEST_F(TrainingGround, WayThroughTheGateEndsAtTheBoard) {
  // Along the path's middle and along both sides of the robot.
  for (const double y : {1.9 - 0.42, 1.9, 1.9 + 0.42}) {
    for (const double z : {0.11, 0.3, 0.9, 1.3}) {
      const Met met = Look({0, y, z}, -Vector3d::UnitX());
      EXPECT_EQ(met.object, "board") << y << " " << z;
      EXPECT_NEAR(met.range, 8.0, 1e-9);
    }
  }
}

TEST_F(TrainingGround, StartPadHasRoomToTurn) {
  // The circle of 1.3 m round the start pad and round the path's points, at the heights of the
  // robot.
  for (const Vector3d& centre :
       {Vector3d(0, 0, 0), Vector3d(0, 1.9, 0), Vector3d(-2, 1.9, 0), Vector3d(-6.5, 1.9, 0)}) {
    for (double angle = 0; angle < 6.28; angle += 0.1) {
      for (const double z : {0.05, 0.3, 0.9, 1.3}) {
        const Vector3d direction(std::cos(angle), std::sin(angle), 0);
        const double range = Look(centre + Vector3d(0, 0, z), direction).range;
        EXPECT_TRUE(range < 0 || range > 1.3) << centre.transpose() << " " << angle << " " << z;
      }
    }
  }
}

TEST_F(TrainingGround, FenceClosesTheYard) {
  EXPECT_EQ(Look({45, 20, 1}, Vector3d::UnitX()).object, "fence");
  EXPECT_EQ(Look({-45, -12, 1}, -Vector3d::UnitX()).object, "fence");
  EXPECT_EQ(Look({20, 45, 1}, Vector3d::UnitY()).object, "fence");
  EXPECT_EQ(Look({20, -45, 1}, -Vector3d::UnitY()).object, "fence");
}

TEST_F(TrainingGround, GapsOfTheFlatModuleAreAsWideAsTheySay) {
  for (const auto& [y, width] : {std::pair(-12.0, 0.20), {0.0, 0.40}}) {
    const double edge = y + 1.6 + 1.2;
    const Vector3d inside(25, edge + width / 2, 0.15);
    EXPECT_NEAR(Look(inside, Vector3d::UnitY()).range, width / 2, 1e-9);
    EXPECT_NEAR(Look(inside, -Vector3d::UnitY()).range, width / 2, 1e-9);
    EXPECT_NEAR(Look({25, edge - 0.5, 1}, -Vector3d::UnitZ()).point.z(), 0.30, 1e-9);
    EXPECT_NEAR(Look({25, edge + width + 0.5, 1}, -Vector3d::UnitZ()).point.z(), 0.30, 1e-9);
  }
}

TEST_F(TrainingGround, NamesAreUniqueInAllModules) {
  std::map<std::string, int> seen;
  size_t still = 0;
  for (const ModuleModel& module : Model().modules) {
    still += module.objects.size();
    for (const WorldObject& object : module.objects) ++seen[object.name];
    for (const MovableObject& movable : module.movables) ++seen[movable.name];
  }
  for (const auto& [name, count] : seen) EXPECT_EQ(count, 1) << name;
  EXPECT_GE(still, 90u);  // the source paper: nearly 100 static models
}

TEST_F(TrainingGround, PicturesStayWithinTheirBudget) {
  // 50,000 visible triangles are what software rendering bears at 25 pictures a second.
  for (const ModuleModel& module : Model().modules) {
    size_t triangles = 0;
    for (const WorldObject& object : module.objects) {
      for (const Visual& visual : object.visuals) {
        triangles += visual.shape == Visual::Shape::kMesh  ? visual.triangles.size() / 3
                     : visual.shape == Visual::Shape::kBox ? 12
                                                           : 100;
      }
    }
    EXPECT_LT(triangles, 50000u) << module.name;
    EXPECT_LT(module.triangles.size(), 20000u) << module.name;
  }
}

TEST_F(TrainingGround, EveryTriangleBelongsToItsModuleAlone) {
  for (const ModuleModel& module : Model().modules) {
    EXPECT_EQ(module.class_bit, 1u << (module.id - 1));
    for (const CollisionTriangle& triangle : module.triangles) {
      ASSERT_EQ(triangle.class_mask & kAnyModule, module.class_bit) << module.name;
      ASSERT_NE(triangle.class_mask & (kClampProxy | kBumpProxy), 0u) << module.name;
    }
  }
}

TEST_F(TrainingGround, SunAndFogComeFromTheFile) {
  EXPECT_GT(Model().atmosphere.sun_direction.z(), 0.5);
  EXPECT_NEAR(Model().atmosphere.sun_direction.norm(), 1, 1e-6);
  EXPECT_FLOAT_EQ(Model().atmosphere.fog_density, 0.005F);
  EXPECT_FLOAT_EQ(Model().atmosphere.sky_colour.z(), 0.85F);
}

}  // namespace
}  // namespace eod::sim
