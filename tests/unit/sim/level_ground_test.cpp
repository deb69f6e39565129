#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "sim/world/built_world.h"

namespace eod::sim {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

constexpr uint32_t kGround = kModuleFlat | kClampProxy;
constexpr uint32_t kMask = kModuleFlat | kClampProxy;

void AddTriangle(ModuleModel& module, const Vector3d& a, const Vector3d& b, const Vector3d& c,
                 uint32_t classes = kGround) {
  module.triangles.push_back({.corner = {a, b, c}, .class_mask = classes});
}

/// A square tile of 1 m, its lowest corner at (x, y), as two triangles that look up.
void AddTile(ModuleModel& module, double x, double y, double z, uint32_t classes = kGround) {
  const Vector3d a(x, y, z), b(x + 1, y, z), c(x + 1, y + 1, z), d(x, y + 1, z);
  AddTriangle(module, a, b, c, classes);
  AddTriangle(module, a, c, d, classes);
}

/// Tiles from -4 to 4 m both ways at `z`; `without` leaves out the one whose corner is there.
ModuleModel Tiles(double z, const Vector3d& without = {9, 9, 0}) {
  ModuleModel module;
  for (int x = -4; x < 4; ++x) {
    for (int y = -4; y < 4; ++y) {
      if (x != without.x() || y != without.y()) AddTile(module, x, y, z);
    }
  }
  return module;
}

AlignedBox3d Around(double x, double y, double z = 0) {
  return {Vector3d(x - 0.3, y - 0.3, z - 0.5), Vector3d(x + 0.3, y + 0.3, z + 0.2)};
}

std::optional<double> LevelIn(const ModuleModel& module, const AlignedBox3d& box) {
  CastMemory memory;
  return BuiltWorld(module).LevelGroundIn(box, kMask, memory);
}

TEST(LevelGround, IsKnownExactlyAcrossTheSeamsOfATiledFloor) {
  const double z = 0.1;
  for (const Vector3d& p : {Vector3d(0.5, 0.5, z), Vector3d(0, 0, z), Vector3d(-1, 0.3, z)}) {
    EXPECT_EQ(LevelIn(Tiles(z), Around(p.x(), p.y(), z)), z);
  }
}

TEST(LevelGround, IsNotThereWhereATileIsMissingOrHigherOrOneSlopes) {
  EXPECT_FALSE(LevelIn(Tiles(0, {1, 1, 0}), Around(0.6, 1.5)));
  ModuleModel step = Tiles(0, {1, 1, 0});
  AddTile(step, 1, 1, 1e-6);
  EXPECT_FALSE(LevelIn(step, Around(0.6, 1.5)));
  ModuleModel slope = Tiles(0, {1, 1, 0});
  AddTriangle(slope, {1, 1, 0}, {2, 1, 0}, {2, 2, 0.01});
  AddTriangle(slope, {1, 1, 0}, {2, 2, 0.01}, {1, 2, 0});
  EXPECT_FALSE(LevelIn(slope, Around(0.6, 1.5)));
}

TEST(LevelGround, EndsWithTheFloorAndIsNotInTheAir) {
  EXPECT_TRUE(LevelIn(Tiles(0), Around(3, 0)));
  EXPECT_FALSE(LevelIn(Tiles(0), Around(3.9, 0)));
  EXPECT_FALSE(LevelIn(Tiles(0), Around(5, 0)));
  EXPECT_FALSE(LevelIn(Tiles(0), Around(0, 0, 2)));
  EXPECT_FALSE(LevelIn({}, Around(0, 0)));
}

TEST(LevelGround, IsNotThereBesideAKerbUnderAPlankOrSeenFromBelow) {
  ModuleModel kerb = Tiles(0);
  AddTriangle(kerb, {0.5, -1, 0}, {0.5, 1, 0}, {0.5, 1, 0.1});
  EXPECT_FALSE(LevelIn(kerb, Around(0.3, 0)));
  ModuleModel plank = Tiles(0);
  AddTile(plank, 0, 0, 0.1);
  EXPECT_FALSE(LevelIn(plank, Around(0.3, 0.3)));
  ModuleModel below = Tiles(0);
  for (CollisionTriangle& triangle : below.triangles) {
    std::swap(triangle.corner[1], triangle.corner[2]);
  }
  EXPECT_FALSE(LevelIn(below, Around(0, 0)));
}

TEST(LevelGround, HasNothingOfWhatTheLinesDoNotLookFor) {
  ModuleModel module = Tiles(0);
  AddTile(module, 0, 0, 0.1, kModuleFlat | kBumpProxy);
  EXPECT_EQ(LevelIn(module, Around(0.3, 0.3)), 0);
}

TEST(LevelGround, IsNotThereWhileAThingStandsOnIt) {
  BuiltWorld dut(Tiles(0));
  CastMemory memory;
  EXPECT_TRUE(dut.LevelGroundIn(Around(0, 0), kMask, memory));
  const int box = dut.AddShape("box", kGround, Shape::Box({0.1, 0.1, 0.1}),
                               Isometry3d(Translation3d(0.2, 0, 0.05)));
  EXPECT_FALSE(dut.LevelGroundIn(Around(0, 0), kMask, memory));
  dut.Move(box, Isometry3d(Translation3d(2, 0, 0.05)));
  EXPECT_TRUE(dut.LevelGroundIn(Around(0, 0), kMask, memory));
}

TEST(LevelGround, IsSurveyedAnewWhenTheWorldChanges) {
  BuiltWorld dut(Tiles(0));
  CastMemory memory;
  EXPECT_EQ(dut.LevelGroundIn(Around(0, 0), kMask, memory), 0);
  dut.Rebuild(Tiles(0.05).triangles);
  EXPECT_EQ(dut.LevelGroundIn(Around(0, 0), kMask, memory), 0.05);
}

/// Whatever is near: where it is known, each line meets it, bit for bit.
TEST(LevelGround, IsWhatEveryVerticalLineMeets) {
  constexpr double kDrop = 0.5;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> anywhere(-3.9, 3.9), within(-0.3, 0.3);
  ModuleModel module = Tiles(0.03, {1, 1, 0});
  AddTile(module, -3, 2, 0.1);
  const BuiltWorld dut(module);
  CastMemory memory, level_memory;
  int known = 0;
  for (int place = 0; place < 500; ++place) {
    const double x = anywhere(random), y = anywhere(random);
    const auto z = dut.LevelGroundIn(Around(x, y), kMask, level_memory);
    known += z ? 1 : 0;
    for (int i = 0; z && i < 20; ++i) {
      const SegmentQuery line{.start = {x + within(random), y + within(random), 0.2},
                              .direction = -Vector3d::UnitZ(),
                              .length = kDrop,
                              .class_mask = kMask,
                              .hit_rule = HitRule::kHighest};
      SegmentHit hit;
      dut.Cast({&line, 1}, {&hit, 1}, memory);
      ASSERT_TRUE(hit.hit);
      EXPECT_EQ(hit.range, line.start.z() - *z);
      EXPECT_EQ(hit.normal, Vector3d::UnitZ());
    }
  }
  EXPECT_GT(known, 250);
  EXPECT_LT(known, 450);
}

}  // namespace
}  // namespace eod::sim
