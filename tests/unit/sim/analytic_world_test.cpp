#include "sim/world/analytic_world.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace eod::sim {
namespace {

using Eigen::Vector3d;

const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();
constexpr uint32_t kGround = kModuleFlat | kClampProxy;

Eigen::Isometry3d At(const Vector3d& p_MO) { return Eigen::Isometry3d(Eigen::Translation3d(p_MO)); }

class Analytic : public ::testing::Test {
 protected:
  AnalyticWorld dut_;
  CastMemory memory_;

  SegmentHit Cast(const SegmentQuery& query) {
    SegmentHit hit;
    dut_.Cast({&query, 1}, {&hit, 1}, memory_);
    return hit;
  }
};

TEST_F(Analytic, ObjectsAreNumberedAsTheyCome) {
  EXPECT_EQ(dut_.AddBox("crate", kBumpProxy, At({0, 3, 0}), {1, 1, 1}), 0);
  EXPECT_EQ(dut_.AddPlane("ground", kGround, -kZ, kZ), 1);
  EXPECT_EQ(dut_.AddShape("bomb", kBombObject, At({0, 6, 0}), Shape::Cylinder(0.06, 0.4)), 2);
  EXPECT_EQ(dut_.ObjectName(2), "bomb");
  const SegmentHit hit = Cast({.direction = kY, .length = 9, .class_mask = kBombObject});
  EXPECT_EQ(hit.object, 2);
  EXPECT_NEAR(hit.range, 5.94, 1e-12);
}

TEST_F(Analytic, AllHitsOfPlanesAndShapesAreListedTogether) {
  dut_.AddPlane("ground", kGround, Vector3d::Zero(), kZ);
  dut_.AddPlane("ceiling", kGround, {0, 0, 3}, -kZ);
  dut_.AddBox("table", kGround, At({0, 0, 1}), {1, 1, 0.5});
  const std::array<SegmentQuery, 3> queries = {
      SegmentQuery{.start = {5, 0, 1}, .direction = kX, .length = 1, .class_mask = kGround},
      SegmentQuery{.start = {0, 0, -1},
                   .direction = kZ,
                   .length = 9,
                   .class_mask = kGround,
                   .hit_rule = HitRule::kAll},
      SegmentQuery{.start = {0, 0, -1},
                   .direction = kZ,
                   .length = 9,
                   .class_mask = kGround,
                   .hit_rule = HitRule::kAll,
                   .face_rule = FaceRule::kFrontOnly}};
  std::array<SegmentHit, 3> hits;
  memory_.all.resize(7);  // left over from before
  dut_.Cast(queries, hits, memory_);
  std::vector<std::pair<int, int>> listed;  // query, object
  for (const ListedHit& one : memory_.all) listed.emplace_back(one.query, one.hit.object);
  // Ground, table in, table out, ceiling; from below the ceiling and the table's underside.
  EXPECT_EQ(listed,
            (std::vector<std::pair<int, int>>{{1, 0}, {1, 2}, {1, 2}, {1, 1}, {2, 2}, {2, 1}}));
  EXPECT_NEAR(memory_.all[2].hit.range, 2.25, 1e-12);
  EXPECT_NEAR(hits[1].range, 1, 1e-12);  // the nearest
  EXPECT_NEAR(hits[2].range, 1.75, 1e-12);
}

TEST_F(Analytic, OfEqualHitsTheLowerObjectAnswers) {
  dut_.AddBox("slab", kGround, At({0, 0, -0.5}), {9, 9, 1});
  dut_.AddPlane("ground", kGround, Vector3d::Zero(), kZ);
  EXPECT_EQ(Cast({.start = kZ, .direction = -kZ, .length = 2, .class_mask = kGround}).object, 0);
}

TEST_F(Analytic, ShapesMoveAndPlanesStay) {
  const int plane = dut_.AddPlane("ground", kGround, Vector3d::Zero(), kZ);
  const int ball = dut_.AddShape("ball", kMovableObject, At({0, 5, 1}), Shape::Sphere(0.5));
  const SegmentQuery query{.start = kZ, .direction = kY, .length = 9, .class_mask = kMovableObject};
  EXPECT_NEAR(Cast(query).range, 4.5, 1e-12);
  EXPECT_TRUE(dut_.Move(ball, At({0, 7, 1})));
  EXPECT_NEAR(Cast(query).range, 6.5, 1e-12);
  EXPECT_FALSE(dut_.Move(plane, At(kZ)));
}

TEST_F(Analytic, WhatCannotBeCastIsRejectedAndMeetsNothing) {
  dut_.AddPlane("ground", kGround, Vector3d::Zero(), kZ);
  dut_.AddBox("crate", kGround, At(Vector3d::Zero()), {1, 1, 1});
  const SegmentQuery good{.start = kZ, .direction = -kZ, .length = 9, .class_mask = kGround};
  std::array<SegmentQuery, 5> queries;
  queries.fill(good);
  queries[1].start.z() = std::nan("");
  queries[2].direction = -2 * kZ;
  queries[3].length = std::numeric_limits<double>::infinity();
  queries[4].length = -1;
  std::array<SegmentHit, 5> hits;
  dut_.Cast(queries, hits, memory_);
  EXPECT_TRUE(hits[0].hit);
  for (size_t i = 1; i < hits.size(); ++i) EXPECT_FALSE(hits[i].hit) << i;
  EXPECT_EQ(memory_.counters.rejected, 4u);
  EXPECT_EQ(memory_.counters.segments, 5u);
}

}  // namespace
}  // namespace eod::sim
