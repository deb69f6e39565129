#include <memory>

#include <gtest/gtest.h>

#include "sim/world/analytic_world.h"
#include "tests/unit/sim/random_scene.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

constexpr uint32_t kBoth = kModuleFlat | kClampProxy | kBumpProxy;

/// A box of 2 m on level ground, as triangles and as exact shapes: both forms of the seam.
std::unique_ptr<World> MakeWorld(bool analytic) {
  if (analytic) {
    auto world = std::make_unique<AnalyticWorld>();
    world->AddPlane("ground", kBoth, Vector3d::Zero(), Vector3d::UnitZ());
    world->AddBox("box", kModuleFlat | kBumpProxy, Eigen::Isometry3d(Eigen::Translation3d(0, 5, 1)),
                  Vector3d(2, 2, 2));
    return world;
  }
  ModuleModel module;
  AddObject(module, "ground", kBoth, PlaneMesh(40, 40, 2));
  AddObject(module, "box", kModuleFlat | kBumpProxy, BoxMesh(Vector3d(2, 2, 2)), {0, 5, 1});
  return BuildWorld(module);
}

class CastWorld : public ::testing::TestWithParam<bool> {
 protected:
  std::unique_ptr<World> dut_ = MakeWorld(GetParam());
  CastMemory memory_;

  SegmentHit Cast(const SegmentQuery& query) {
    SegmentHit hit;
    dut_->Cast({&query, 1}, {&hit, 1}, memory_);
    return hit;
  }
  /// Forward from y = `from` at 0.7 m height (off every edge and diagonal).
  SegmentQuery Forward(double from, double length) {
    return {.start = {0.3, from, 0.7},
            .direction = Vector3d::UnitY(),
            .length = length,
            .class_mask = kModuleFlat | kBumpProxy};
  }
};

TEST_P(CastWorld, HitTellsPointNormalRangeAndObject) {
  const SegmentHit hit = Cast(Forward(1, 10));
  ASSERT_TRUE(hit.hit);
  EXPECT_NEAR(hit.range, 3, 1e-12);  // near face at y = 4
  EXPECT_LT((hit.point - Vector3d(0.3, 4, 0.7)).norm(), 1e-12);
  EXPECT_LT((hit.normal + Vector3d::UnitY()).norm(), 1e-12);
  EXPECT_EQ(dut_->ObjectName(hit.object), "box");
  EXPECT_EQ(hit.object_class, kModuleFlat | kBumpProxy);
}

TEST_P(CastWorld, BothEndsCount) {
  EXPECT_EQ(Cast(Forward(4, 0.5)).range, 0);  // starts on the face
  EXPECT_TRUE(Cast(Forward(4, 0.5)).hit);
  EXPECT_TRUE(Cast(Forward(3.5, 0.5)).hit);  // ends on the face
  EXPECT_EQ(Cast(Forward(3.5, 0.5)).range, 0.5);
  EXPECT_FALSE(Cast(Forward(3.5, 0.4999)).hit);
  EXPECT_FALSE(Cast(Forward(6.0001, 5)).hit);
}

TEST_P(CastWorld, FacesAreMetFromInsideUnlessOnlyFrontsCount) {
  SegmentQuery query = Forward(5, 3);  // from the box's middle to its far face
  EXPECT_NEAR(Cast(query).range, 1, 1e-12);
  query.face_rule = FaceRule::kFrontOnly;
  EXPECT_FALSE(Cast(query).hit);
  EXPECT_TRUE(Cast({.start = {0.3, 1, 0.7},
                    .direction = Vector3d::UnitY(),
                    .length = 10,
                    .class_mask = kBumpProxy,
                    .face_rule = FaceRule::kFrontOnly})
                  .hit);
}

TEST_P(CastWorld, MaskDecidesWhatIsMet) {
  SegmentQuery query = Forward(1, 10);
  query.class_mask = kModuleFlat | kClampProxy;  // the box is no clamp proxy
  EXPECT_FALSE(Cast(query).hit);
  query.class_mask = kModuleSlope | kBumpProxy;  // another module
  EXPECT_FALSE(Cast(query).hit);
  query.class_mask = kBumpProxy;  // no module named: any
  EXPECT_TRUE(Cast(query).hit);
  query.class_mask = 0;
  EXPECT_FALSE(Cast(query).hit);
}

TEST_P(CastWorld, HighestHitOfALineIsTakenWhicheverWayItRuns) {
  SegmentQuery query{.start = {0.3, 5.2, -1},
                     .direction = Vector3d::UnitZ(),
                     .length = 6,
                     .class_mask = kBoth,
                     .hit_rule = HitRule::kHighest};
  EXPECT_NEAR(Cast(query).point.z(), 2, 1e-12);
  EXPECT_NEAR(Cast(query).range, 3, 1e-12);
  query.hit_rule = HitRule::kNearest;
  EXPECT_NEAR(Cast(query).point.z(), 0, 1e-12);
  query = {.start = {0.3, 5.2, 5},
           .direction = -Vector3d::UnitZ(),
           .length = 6,
           .class_mask = kBoth,
           .hit_rule = HitRule::kHighest};
  EXPECT_NEAR(Cast(query).point.z(), 2, 1e-12);
}

TEST_P(CastWorld, LineAlongASurfaceMeetsNothingOfIt) {
  EXPECT_FALSE(
      Cast({.start = {5, 0, 0}, .direction = Vector3d::UnitX(), .length = 3, .class_mask = kBoth})
          .hit);
}

TEST_P(CastWorld, EveryQueryIsAnsweredAndCounted) {
  const std::array<SegmentQuery, 3> queries = {Forward(1, 10), Forward(1, 1), Forward(5, 10)};
  std::array<SegmentHit, 3> hits;
  hits[1].hit = true;  // left over from before
  dut_->Cast(queries, hits, memory_);
  EXPECT_TRUE(hits[0].hit);
  EXPECT_FALSE(hits[1].hit);
  EXPECT_TRUE(hits[2].hit);
  EXPECT_EQ(memory_.counters.segments, 3u);
  EXPECT_GT(memory_.counters.candidates, 0u);
}

TEST_P(CastWorld, UnknownObjectHasNoName) {
  EXPECT_EQ(dut_->ObjectName(-1), "");
  EXPECT_EQ(dut_->ObjectName(99), "");
}

INSTANTIATE_TEST_SUITE_P(BothForms, CastWorld, ::testing::Bool(),
                         [](const auto& one) { return one.param ? "Analytic" : "Triangles"; });

TEST(EmptyWorld, MeetsNothing) {
  const auto dut = BuildWorld(ModuleModel{});
  const SegmentQuery query{.length = 10, .class_mask = kBoth};
  SegmentHit hit;
  CastMemory memory;
  dut->Cast({&query, 1}, {&hit, 1}, memory);
  EXPECT_FALSE(hit.hit);
}

TEST(ModuleMask, OfFiveEqualModulesAFifthOfTheWorkIsLeft) {
  // The source paper's claim for masks: five parts of equal size, one of them asked for.
  ModuleModel module;
  for (uint32_t i = 0; i < 5; ++i) {
    AddObject(module, "ground", (1u << i) | kClampProxy, PlaneMesh(40, 40, 1));
  }
  const auto dut = BuildWorld(module);
  SeededNumbers numbers(1);
  CastMemory all, one;
  for (int i = 0; i < 2000; ++i) {
    SegmentQuery query{.start = {numbers.Between(-19, 19), numbers.Between(-19, 19), 1},
                       .direction = -Vector3d::UnitZ(),
                       .length = 1.5,
                       .class_mask = kClampProxy};
    SegmentHit hit;
    dut->Cast({&query, 1}, {&hit, 1}, all);
    query.class_mask = kModuleBomb | kClampProxy;
    dut->Cast({&query, 1}, {&hit, 1}, one);
    ASSERT_EQ(hit.object_class & kAnyModule, kModuleBomb);
  }
  EXPECT_NEAR(
      static_cast<double>(one.counters.candidates) / static_cast<double>(all.counters.candidates),
      0.20, 0.02);
}

}  // namespace
}  // namespace eod::sim
