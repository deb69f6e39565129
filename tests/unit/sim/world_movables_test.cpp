#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/geometry/object_class.h"
#include "sim/world/built_world.h"
#include "tests/unit/sim/edited_file.h"

namespace eod::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kCharge =
    "<model name=\"charge\">\n<pose relative_to=\"flat\">2 3 0.12 0 0 0</pose>\n"
    "<eod:movable friction=\"0.6\"/>\n<eod:explosive/>\n<link name=\"link\">\n"
    "<inertial><pose>0 0 -0.01 0 0 0</pose><mass>3</mass></inertial>\n"
    "<collision name=\"c1\">"
    "<geometry><cylinder><radius>0.06</radius><length>0.24</length></cylinder></geometry>"
    "</collision>\n"
    "<visual name=\"v1\"><pose>0 0 0.05 0 0 0</pose>"
    "<geometry><sphere><radius>0.02</radius></sphere></geometry></visual>\n"
    "</link>\n</model>\n";
constexpr const char* kDrum =
    "<eod:vessel kind=\"drum\" inner_radius_m=\"0.25\" net_m=\"0.65\" rim_m=\"1.0\"/>";

class WorldMovables : public ::testing::Test {
 protected:
  WorldMovables() { world_.Replace("<model name=\"ground\"", kCharge + kGround); }

  ModuleModel Module() { return LoadWorld(world_.file()).Module(1); }
  std::string Load() {
    try {
      LoadWorld(world_.file());
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "loaded";
  }

  const std::string kGround = "<model name=\"ground\"";
  EditedFile world_{EOD_DATA_DIR "/sim/worlds/training_ground.sdf"};
};

TEST_F(WorldMovables, ChargeIsReadAsItStandsInTheFile) {
  const ModuleModel module = Module();
  ASSERT_EQ(module.movables.size(), 1u);
  const MovableObject& charge = module.movables[0];
  EXPECT_EQ(charge.name, "charge");
  EXPECT_EQ(charge.object_class, kModuleFlat | kBumpProxy | kBombObject);
  EXPECT_EQ(charge.X_MO.translation(), Eigen::Vector3d(2, 3, 0.12));
  EXPECT_EQ(charge.mass, 3);
  EXPECT_EQ(charge.p_OC, Eigen::Vector3d(0, 0, -0.01));
  EXPECT_EQ(charge.friction, 0.6);
  ASSERT_TRUE(charge.explosive);
  EXPECT_EQ(charge.explosive->radius, 0.06);
  EXPECT_EQ(charge.explosive->half_height, 0.12);
  ASSERT_EQ(charge.visuals.size(), 1u);
  EXPECT_EQ(charge.visuals[0].X_OV.translation().z(), 0.05);
  for (const WorldObject& object : module.objects) EXPECT_NE(object.name, "charge");
}

TEST_F(WorldMovables, WithoutExplosiveItIsAMovableOfManyParts) {
  world_.Replace("<eod:explosive/>", "");
  world_.Replace("<collision name=\"c1\">",
                 "<collision name=\"c0\"><pose>0 0 0.2 0 0 0</pose><geometry><capsule><radius>0.02"
                 "</radius><length>0.1</length></capsule></geometry></collision>"
                 "<collision name=\"c1\">");
  const ModuleModel module = Module();
  EXPECT_EQ(module.movables[0].object_class, kModuleFlat | kBumpProxy | kMovableObject);
  EXPECT_FALSE(module.movables[0].explosive);
  ASSERT_EQ(module.movables[0].parts.size(), 2u);
  EXPECT_EQ(module.movables[0].parts[0].X_OS.translation().z(), 0.2);
  EXPECT_TRUE(std::holds_alternative<CapsuleSolid>(module.movables[0].parts[0].shape.solid()));
}

TEST_F(WorldMovables, BuiltWorldMeetsMovesAndHidesIt) {
  const ModuleModel module = Module();
  BuiltWorld world(module);
  const int object = world.ObjectOfMovable(0);
  EXPECT_EQ(object, static_cast<int>(module.objects.size()));
  EXPECT_EQ(world.ObjectName(object), "charge");
  EXPECT_EQ(world.MovableOfObject(object), 0);
  EXPECT_EQ(world.MovableOfObject(object - 1), -1);
  EXPECT_EQ(world.MovableOfObject(object + 1), -1);
  CastMemory memory;
  const auto hit_from = [&](double x) {
    const SegmentQuery down{.start = {x, 3, 2},
                            .direction = -Eigen::Vector3d::UnitZ(),
                            .length = 1.9,
                            .class_mask = kModuleFlat | kBumpProxy};
    SegmentHit hit;
    world.Cast({&down, 1}, {&hit, 1}, memory);
    return hit.hit ? hit.object : -1;
  };
  EXPECT_EQ(hit_from(2), object);
  EXPECT_TRUE(world.Move(object, Eigen::Isometry3d(Eigen::Translation3d(5, 3, 0.12))));
  EXPECT_EQ(hit_from(2), -1);
  EXPECT_EQ(hit_from(5), object);
  EXPECT_TRUE(world.Hide(object));
  EXPECT_EQ(hit_from(5), -1);
  EXPECT_TRUE(world.Move(object, module.movables[0].X_MO));
  EXPECT_EQ(hit_from(2), object);
  EXPECT_FALSE(world.Hide(0)) << "the ground";
}

TEST_F(WorldMovables, WrongMovablesAreRefusedWithTheirPlace) {
  struct Row {
    const char *from, *to, *place, *text;
  };
  for (const Row& row : {
           Row{"<mass>3</mass>", "<mass>0</mass>", "<link name=\"link\">", "<mass> above 0"},
           Row{"<inertial><pose>0 0 -0.01 0 0 0</pose><mass>3</mass></inertial>", "<!-- none -->",
               "<link name=\"link\">", "needs <inertial>"},
           Row{"friction=\"0.6\"", "friction=\"-1\"", "<eod:movable", "friction = -1"},
           Row{"friction=\"0.6\"", "fricton=\"0.6\"", "<eod:movable", "fricton"},
           Row{"<collision name=\"c1\">", "<collision name=\"c1\"><eod:cone/>",
               "<collision name=\"c1\">", "allowed are box, cylinder, sphere and capsule"},
           Row{"<collision name=\"c1\">", "<collision name=\"c1\"><eod:proxy kind=\"bump\"/>",
               "<collision name=\"c1\">", "takes no <eod:proxy>"},
           Row{"<collision name=\"c1\">", "<collision name=\"c1\"><pose>0 0 0.1 0 0 0</pose>",
               "<eod:explosive", "centred"},
           Row{"<collision name=\"c1\">", "<collision name=\"c1\"><pose>0 0 0 1 0 0</pose>",
               "<eod:explosive", "upright"},
           Row{"<link name=\"link\">", "<link name=\"more\"/><link name=\"link\">",
               "<model name=\"charge\">", "needs one link"},
           Row{"<eod:explosive/>", kDrum, "<eod:vessel", "eod:vessel"},
       }) {
    world_.Replace(row.from, row.to);
    EXPECT_THAT(Load(), AllOf(StartsWith(world_.PlaceOf(row.place)), HasSubstr(row.text)))
        << row.to;
    world_.Replace(row.to, row.from);
  }
}

class WorldVessels : public WorldMovables {
 protected:
  void GiveGround(const std::string& vessel) {
    world_.Replace(kGround + ">", kGround + ">" + vessel);
  }
};

TEST_F(WorldVessels, DrumIsReadAndItsTrianglesSaySo) {
  GiveGround(kDrum);
  const ModuleModel module = Module();
  ASSERT_EQ(module.vessels.size(), 1u);
  EXPECT_EQ(module.vessels[0].name, "ground");
  EXPECT_EQ(module.vessels[0].inner_radius, 0.25);
  EXPECT_EQ(module.vessels[0].net_z, 0.65);
  EXPECT_EQ(module.vessels[0].rim_z, 1.0);
  const uint32_t mask = module.triangles[0].class_mask;
  EXPECT_EQ(mask, kModuleFlat | kContainmentVessel | kClampProxy | kBumpProxy);
  EXPECT_TRUE(Accepts(kModuleFlat | kBumpProxy, mask)) << "BUMP still runs into it";
  EXPECT_TRUE(Accepts(kModuleFlat | kClampProxy, mask));
  EXPECT_TRUE(Accepts(kModuleFlat | kContainmentVessel, mask));
  EXPECT_FALSE(Accepts(kModuleBomb | kContainmentVessel, mask));
  EXPECT_EQ(module.triangles.back().class_mask & kContainmentVessel, 0u);
}

TEST_F(WorldVessels, ChamberHasHalfSizes) {
  GiveGround(
      "<eod:vessel kind=\"chamber\" inner_x_m=\"0.8\" inner_y_m=\"0.6\" net_m=\"0.7\" "
      "rim_m=\"1.4\"/>");
  const ModuleModel module = Module();
  EXPECT_EQ(module.vessels[0].inner_radius, 0);
  EXPECT_EQ(module.vessels[0].half_size, Eigen::Vector3d(0.4, 0.3, 0));
}

TEST_F(WorldVessels, NetAboveTheRimIsRefused) {
  GiveGround("<eod:vessel kind=\"drum\" inner_radius_m=\"0.25\" net_m=\"1.1\" rim_m=\"1.0\"/>");
  EXPECT_THAT(Load(), AllOf(StartsWith(world_.PlaceOf("<eod:vessel")), HasSubstr("net_m = 1.1")));
}

TEST_F(WorldVessels, UnknownKindIsRefused) {
  GiveGround("<eod:vessel kind=\"bucket\" net_m=\"0.1\" rim_m=\"1.0\"/>");
  EXPECT_THAT(Load(),
              AllOf(StartsWith(world_.PlaceOf("<eod:vessel")), HasSubstr("allowed drum, chamber")));
}

}  // namespace
}  // namespace eod::sim
