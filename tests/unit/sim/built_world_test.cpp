#include "sim/world/built_world.h"

#include <gtest/gtest.h>

#include "tests/unit/sim/random_scene.h"

namespace eod::sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

constexpr uint32_t kGround = kModuleFlat | kClampProxy | kBumpProxy;
constexpr uint32_t kBomb = kModuleFlat | kBombObject;
constexpr uint32_t kAll = kModuleFlat | kBumpProxy | kBombObject;

Isometry3d At(double x, double y, double z) { return Isometry3d(Translation3d(x, y, z)); }

/// Ground of 40 m, a bomb of 0.12 m diameter standing 2 m ahead.
class WorldWithABomb : public ::testing::Test {
 protected:
  static constexpr double kRadius = 0.06, kHeight = 0.24, kAhead = 2;

  WorldWithABomb() : dut_(Ground()) {
    bomb_ =
        dut_.AddShape("bomb", kBomb, Shape::Cylinder(kRadius, kHeight), At(0, kAhead, kHeight / 2));
  }
  static ModuleModel Ground() {
    ModuleModel module;
    AddObject(module, "ground", kGround, PlaneMesh(40, 40, 1));
    return module;
  }
  SegmentHit Cast(const SegmentQuery& query) {
    SegmentHit hit;
    dut_.Cast({&query, 1}, {&hit, 1}, memory_);
    return hit;
  }
  static SegmentQuery Forward() {
    return {
        .start = {0, 0.3, 0.1}, .direction = Vector3d::UnitY(), .length = 3, .class_mask = kAll};
  }
  static SegmentQuery Down(double y) {
    return {.start = {0, y, 1}, .direction = -Vector3d::UnitZ(), .length = 2, .class_mask = kAll};
  }

  BuiltWorld dut_;
  CastMemory memory_;
  int bomb_ = -1;
};

TEST_F(WorldWithABomb, ShapesAndTrianglesAnswerTogether) {
  const SegmentHit ahead = Cast(Forward());
  EXPECT_EQ(dut_.ObjectName(ahead.object), "bomb");
  EXPECT_EQ(ahead.object_class, kBomb);
  EXPECT_NEAR(ahead.range, kAhead - kRadius - 0.3, 1e-12);
  const SegmentHit on_top = Cast(Down(kAhead));
  EXPECT_EQ(on_top.object, bomb_);
  EXPECT_NEAR(on_top.point.z(), kHeight, 1e-12);
  const SegmentHit beside = Cast(Down(kAhead + 2 * kRadius));
  EXPECT_EQ(dut_.ObjectName(beside.object), "ground");
}

TEST_F(WorldWithABomb, AllHitsListShapesAndTrianglesByRange) {
  SegmentQuery query = Down(kAhead);
  query.hit_rule = HitRule::kAll;
  Cast(query);
  ASSERT_GE(memory_.all.size(), 3u);
  EXPECT_EQ(memory_.all[0].hit.object, bomb_);
  EXPECT_NEAR(memory_.all[0].hit.range, 1 - kHeight, 1e-12);
  for (size_t i = 1; i < memory_.all.size(); ++i) {
    EXPECT_NEAR(memory_.all[i].hit.range, 1, 1e-9);  // the bomb's bottom and the ground
  }
}

TEST_F(WorldWithABomb, MovedObjectIsMetWhereItIsNow) {
  EXPECT_TRUE(dut_.Move(bomb_, At(0, kAhead + 0.5, kHeight / 2)));
  EXPECT_NEAR(Cast(Forward()).range, kAhead + 0.5 - kRadius - 0.3, 1e-12);
  EXPECT_FALSE(dut_.Move(0, Isometry3d::Identity()));  // the ground does not move
}

TEST_F(WorldWithABomb, RemovedObjectIsMetNoMoreAndKeepsItsName) {
  EXPECT_TRUE(dut_.Remove(bomb_));
  EXPECT_FALSE(Cast(Forward()).hit);
  EXPECT_FALSE(dut_.Remove(bomb_));
  EXPECT_EQ(dut_.ObjectName(bomb_), "bomb");
  EXPECT_NE(dut_.AddShape("next", kBomb, Shape::Sphere(0.1), At(0, 1, 0.1)), bomb_);
}

TEST_F(WorldWithABomb, MaskThatLooksForNoBombsPassesThroughThem) {
  SegmentQuery query = Forward();
  query.class_mask = kModuleFlat | kBumpProxy;
  EXPECT_FALSE(Cast(query).hit);
}

TEST_F(WorldWithABomb, RebuiltGroundIsSeenAtOnce) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(Cast(Down(0)).range, 1, 1e-12);
  ModuleModel lower;
  AddObject(lower, "ground", kGround, PlaneMesh(40, 40, 1), {0, 0, -0.5});
  dut_.Rebuild(lower.triangles);
  EXPECT_NEAR(Cast(Down(0)).range, 1.5, 1e-12);
  EXPECT_EQ(Cast(Down(kAhead)).object, bomb_);
}

TEST_F(WorldWithABomb, BrokenTrianglesLeaveTheWorldAsItWas) {
  ModuleModel broken = Ground();
  broken.triangles[0].corner[0].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(dut_.Rebuild(broken.triangles), std::invalid_argument);
  EXPECT_NEAR(Cast(Down(0)).range, 1, 1e-12);
}

TEST_F(WorldWithABomb, BadSegmentIsCountedOnce) {
  SegmentQuery query = Forward();
  query.length = -1;
  EXPECT_FALSE(Cast(query).hit);
  EXPECT_EQ(memory_.counters.rejected, 1u);
  EXPECT_EQ(memory_.counters.segments, 1u);
}

}  // namespace
}  // namespace eod::sim
