#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "sim/world/segment_triangle.h"
#include "tests/unit/sim/random_scene.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

constexpr size_t kSegments = 100000;

/// Every triangle against the segment: what the tree must agree with.
struct Expected {
  double range = 0;
  int triangle = -1;
};

/// Box round each triangle or segment.
struct Extent {
  Vector3d low, high;
  bool FarFrom(const Extent& other) const {  // a millimetre apart: no need to look closer
    return ((low - other.high).array() > 1e-3).any() || ((other.low - high).array() > 1e-3).any();
  }
};

std::vector<Extent> ExtentsOf(const ModuleModel& module) {
  std::vector<Extent> extents;
  for (const CollisionTriangle& triangle : module.triangles) {
    const auto& [a, b, c] = triangle.corner;
    extents.push_back({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)});
  }
  return extents;
}

Expected CastAll(const ModuleModel& module, const std::vector<Extent>& extents,
                 const SegmentQuery& query) {
  const PreparedSegment segment(query.start, query.direction, query.length, query.face_rule);
  const Vector3d end = query.start + query.length * query.direction;
  const Extent around{query.start.cwiseMin(end), query.start.cwiseMax(end)};
  Expected best;
  for (size_t i = 0; i < module.triangles.size(); ++i) {
    if (around.FarFrom(extents[i])) continue;
    if (!Accepts(query.class_mask, module.triangles[i].class_mask)) continue;
    const auto range = segment.Meet(module.triangles[i].corner);
    if (range && (best.triangle < 0 || *range < best.range)) best = {*range, static_cast<int>(i)};
  }
  return best;
}

/// Segments of all lengths: into the blue, along the axes, and aimed at corners and edges.
std::vector<SegmentQuery> RandomSegments(const ModuleModel& module, size_t count, uint64_t seed) {
  SeededNumbers numbers(seed);
  std::vector<SegmentQuery> queries;
  while (queries.size() < count) {
    SegmentQuery query;
    query.start = numbers.InBox(20);
    query.length = numbers.Below(4) == 0 ? numbers.Between(1, 40) : numbers.Between(0.05, 1);
    query.class_mask = kModuleFlat | (numbers.Below(4) == 0 ? kClampProxy : kBumpProxy);
    query.face_rule = numbers.Below(4) == 0 ? FaceRule::kFrontOnly : FaceRule::kTwoSided;
    query.direction = numbers.InBox(1).normalized();
    const auto& corner = module.triangles[numbers.Below(module.triangles.size())].corner;
    const size_t kind = queries.size() % 4;
    if (kind == 0) query.direction = Vector3d::Unit(static_cast<int>(numbers.Below(3)));
    if (kind >= 2) {  // at a corner, or at the middle of an edge
      const Vector3d target = kind == 2 ? corner[0] : Vector3d((corner[0] + corner[1]) / 2);
      query.start = target - query.length * 0.5 * query.direction;
    }
    queries.push_back(query);
  }
  return queries;
}

TEST(TriangleTree, AgreesWithEveryTriangleOverAHundredThousandSegments) {
  const ModuleModel module = RandomScene(1);
  const std::unique_ptr<World> dut = BuildWorld(module);
  const std::vector<Extent> extents = ExtentsOf(module);
  const auto queries = RandomSegments(module, kSegments, 2);
  std::vector<SegmentHit> hits(queries.size());
  CastMemory memory;
  dut->Cast(queries, hits, memory);

  size_t missed = 0, extra = 0, different = 0, hit = 0;
  for (size_t i = 0; i < queries.size(); ++i) {
    const Expected expected = CastAll(module, extents, queries[i]);
    if (expected.triangle >= 0) ++hit;
    if (expected.triangle >= 0 && !hits[i].hit) ++missed;
    if (expected.triangle < 0 && hits[i].hit) ++extra;
    if (expected.triangle >= 0 && hits[i].hit &&
        (hits[i].range != expected.range || hits[i].triangle != expected.triangle)) {
      ++different;
    }
  }
  EXPECT_EQ(missed, 0u);
  EXPECT_EQ(extra, 0u);
  EXPECT_EQ(different, 0u);
  EXPECT_GT(hit, kSegments / 4);
  EXPECT_EQ(memory.counters.segments, kSegments);
}

TEST(TriangleTree, NoSegmentSlipsThroughTheSeamsOfAClosedSurface) {
  // Straight down at every corner and edge of the ground's grid, at odd offsets and slants.
  ModuleModel module;
  AddObject(module, "ground", kModuleFlat | kClampProxy, PlaneMesh(40, 40, 1));
  AddObject(module, "ball", kModuleFlat | kBumpProxy, SphereMesh(3, 12, 24), {0, 0, 8});
  const std::unique_ptr<World> dut = BuildWorld(module);
  SeededNumbers numbers(3);
  size_t missed = 0;
  CastMemory memory;
  for (int i = 0; i < 60000; ++i) {
    const bool at_ball = i % 2 == 0;
    const auto& corner =
        module.triangles[at_ball ? 3200 + numbers.Below(528) : numbers.Below(3200)].corner;
    const double share = numbers.Below(3) == 0 ? 0 : numbers.Between(0, 1);
    const Vector3d target = corner[0] + share * (corner[1] - corner[0]);
    if (!at_ball && (std::abs(target.x()) > 19.9 || std::abs(target.y()) > 19.9)) continue;
    // From outside the ball towards a point of its surface and on to its middle: it must be met.
    const Vector3d start =
        at_ball ? Vector3d(Vector3d(0, 0, 8) + 4 * numbers.InBox(1).normalized())
                : Vector3d(target + Vector3d(numbers.Between(-1, 1), numbers.Between(-1, 1), 2));
    // Not along the rim, where it may rightly pass by: at least 17 degrees above the surface.
    const Vector3d outwards = (target - Vector3d(0, 0, 8)).normalized();
    if (at_ball && (start - target).normalized().dot(outwards) < 0.3) continue;
    const SegmentQuery query{.start = start,
                             .direction = (target - start).normalized(),
                             .length = (target - start).norm() + 0.5,
                             .class_mask = at_ball ? kBumpProxy : kClampProxy};
    SegmentHit hit;
    dut->Cast({&query, 1}, {&hit, 1}, memory);
    if (!hit.hit) ++missed;
  }
  EXPECT_EQ(missed, 0u);
}

TEST(TriangleTree, TwoWorldsOfOneModelGiveTheSameBits) {
  const ModuleModel module = RandomScene(5);
  const auto one = BuildWorld(module), other = BuildWorld(module);
  const auto queries = RandomSegments(module, 20000, 6);
  std::vector<SegmentHit> hits(queries.size()), others(queries.size());
  CastMemory memory, other_memory;
  one->Cast(queries, hits, memory);
  other->Cast(queries, others, other_memory);
  for (size_t i = 0; i < hits.size(); ++i) {
    ASSERT_EQ(hits[i].hit, others[i].hit);
    ASSERT_EQ(hits[i].range, others[i].range);
    ASSERT_EQ(hits[i].point, others[i].point);
    ASSERT_EQ(hits[i].triangle, others[i].triangle);
  }
  EXPECT_EQ(memory.counters.candidates, other_memory.counters.candidates);
}

TEST(TriangleTree, OffersFewTrianglesOfManyToAShortSegment) {
  // 100,000 triangles of ground; a leg of the tripod lies within one cell and its neighbours.
  ModuleModel module;
  AddObject(module, "ground", kModuleFlat | kClampProxy, PlaneMesh(224, 224, 1));
  ASSERT_GE(module.triangles.size(), 100000u);
  const auto dut = BuildWorld(module);
  SeededNumbers numbers(7);
  std::vector<SegmentQuery> queries;
  for (int i = 0; i < 10000; ++i) {
    queries.push_back({.start = {numbers.Between(-100, 100), numbers.Between(-100, 100), 0.45},
                       .direction = -Vector3d::UnitZ(),
                       .length = 3.45,
                       .class_mask = kModuleFlat | kClampProxy,
                       .hit_rule = HitRule::kHighest});
  }
  std::vector<SegmentHit> hits(queries.size());
  CastMemory memory;
  dut->Cast(queries, hits, memory);
  EXPECT_LE(memory.counters.candidates, 10000u * 12);
  for (const SegmentHit& hit : hits) {
    ASSERT_TRUE(hit.hit);
    ASSERT_NEAR(hit.range, 0.45, 1e-12);
  }
}

}  // namespace
}  // namespace eod::sim
