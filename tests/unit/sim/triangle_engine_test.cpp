#include "sim/segments/triangle_engine.h"

#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/counting_new.h"
#include "tests/unit/sim/random_scene.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

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

TEST(TriangleEngine, NoSegmentSlipsThroughTheSeamsOfAClosedSurface) {
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

TEST(TriangleEngine, TwoWorldsOfOneModelGiveTheSameBits) {
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

TEST(TriangleEngine, OffersFewTrianglesOfManyToAShortSegment) {
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
  EXPECT_LE(memory.counters.candidates, 10000u * 2 * kBlockSize);
  for (const SegmentHit& hit : hits) {
    ASSERT_TRUE(hit.hit);
    ASSERT_NEAR(hit.range, 0.45, 1e-12);
  }
}

/// A robot's forty lines about `middle`, ten groups of four.
std::vector<SegmentQuery> LinesAround(const Vector3d& middle, SeededNumbers& numbers) {
  std::vector<SegmentQuery> queries;
  queries.reserve(40);
  for (uint32_t i = 0; i < 40; ++i) {
    queries.push_back({.start = middle + numbers.InBox(0.8),
                       .direction = numbers.InBox(1).normalized(),
                       .length = numbers.Between(0.1, 0.6),
                       .class_mask = kModuleFlat | kBumpProxy,
                       .group = i / 4});
  }
  return queries;
}

TEST(TriangleEngine, GathersItsSurroundingsOnlyWhenTheRobotLeavesThem) {
  const ModuleModel module = RandomScene(11);
  const TriangleEngine dut(module.triangles);
  CastMemory memory;
  std::vector<SegmentHit> hits(40);
  constexpr double kStep = 0.01;
  constexpr int kSteps = 1000;
  SeededNumbers numbers(12);
  const std::vector<SegmentQuery> lines = LinesAround(Vector3d(-5, 0, 0.5), numbers);
  for (int i = 0; i < kSteps; ++i) {
    std::vector<SegmentQuery> moved = lines;
    for (SegmentQuery& query : moved) query.start.x() += i * kStep;
    dut.Cast(moved, hits, memory);
  }
  // 10 m in all, a new list each time half a metre is behind it.
  const double expected = kSteps * kStep / Surroundings::kMargin;
  EXPECT_GT(memory.counters.refills, expected * 0.8);
  EXPECT_LT(memory.counters.refills, expected * 1.2);
}

TEST(TriangleEngine, AllocatesNothingOnceAReaderHasSeenItsLargestCast) {
  const ModuleModel module = RandomScene(13);
  const TriangleEngine dut(module.triangles);
  CastMemory memory;
  SeededNumbers numbers(14);
  std::vector<SegmentHit> hits(40);
  const auto all_of = [&](const Vector3d& middle) {
    std::vector<SegmentQuery> queries = LinesAround(middle, numbers);
    queries[0].hit_rule = HitRule::kAll;
    queries[0].length = 30;
    return queries;
  };
  std::vector<std::vector<SegmentQuery>> frames;
  frames.reserve(200);
  for (int i = 0; i < 200; ++i) frames.push_back(all_of({-10 + 0.1 * i, 0, 0.5}));
  for (const auto& frame : frames) dut.Cast(frame, hits, memory);
  const uint64_t before = AllocationCount();
  for (const auto& frame : frames) dut.Cast(frame, hits, memory);
  EXPECT_EQ(AllocationCount(), before);
  EXPECT_GT(memory.counters.refills, 20u);
}

TEST(TriangleEngine, ManyThreadsReadOneWorldAndGetTheSameBits) {
  const ModuleModel module = RandomScene(15);
  const TriangleEngine dut(module.triangles);
  const auto queries = RandomSegments(module, 5000, 16);
  std::vector<SegmentHit> expected(queries.size());
  CastMemory memory;
  dut.Cast(queries, expected, memory);
  std::atomic<int> different{0};
  {
    std::vector<std::jthread> threads;
    threads.reserve(4);
    for (int i = 0; i < 4; ++i) {
      threads.emplace_back([&] {
        std::vector<SegmentHit> hits(queries.size());
        CastMemory own;
        dut.Cast(queries, hits, own);
        for (size_t q = 0; q < hits.size(); ++q) {
          if (hits[q].range != expected[q].range || hits[q].triangle != expected[q].triangle) {
            ++different;
          }
        }
      });
    }
  }
  EXPECT_EQ(different, 0);
}

class EngineOfOneSquare : public ::testing::Test {
 protected:
  static constexpr uint32_t kClass = kModuleFlat | kBumpProxy;

  /// 2 m x 2 m facing up, at this height.
  static void AddSquare(std::vector<CollisionTriangle>& triangles, double height, int object) {
    for (Triangle corner : PlaneMesh(2, 2, 2)) {
      for (Vector3d& point : corner) point.z() += height;
      triangles.push_back({corner, kClass, object});
    }
  }
  static std::vector<CollisionTriangle> Square(double height) {
    std::vector<CollisionTriangle> triangles;
    AddSquare(triangles, height, 0);
    return triangles;
  }
  static SegmentHit Cast(const TriangleEngine& dut, const SegmentQuery& query, CastMemory& memory) {
    SegmentHit hit;
    dut.Cast({&query, 1}, {&hit, 1}, memory);
    return hit;
  }
  static SegmentQuery Down(double length) {
    return {.start = {0.3, 0.2, 1},
            .direction = -Vector3d::UnitZ(),
            .length = length,
            .class_mask = kClass};
  }
};

TEST_F(EngineOfOneSquare, RefusesWhatIsNoSegmentAndCountsIt) {
  const TriangleEngine dut(Square(0));
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<SegmentQuery> bad(7, Down(2));
  bad[0].start.x() = kNaN;
  bad[1].start.z() = kInfinity;
  bad[2].direction.y() = kNaN;
  bad[3].direction = Vector3d::Zero();
  bad[4].direction = {0, 0, -2};
  bad[5].length = kInfinity;
  bad[6].length = -1;
  for (const SegmentQuery& query : bad) {
    CastMemory memory;
    EXPECT_FALSE(Cast(dut, query, memory).hit);
    EXPECT_EQ(memory.counters.rejected, 1u);
  }
  CastMemory memory;
  EXPECT_TRUE(Cast(dut, Down(2), memory).hit);
  EXPECT_EQ(memory.counters.rejected, 0u);
}

TEST_F(EngineOfOneSquare, RefusesTrianglesThatAreNone) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e7}) {
    auto triangles = Square(0);
    triangles[1].corner[2].y() = bad;
    EXPECT_THROW(TriangleEngine{triangles}, std::invalid_argument);
  }
}

TEST_F(EngineOfOneSquare, ListsAllHitsInOrder) {
  std::vector<CollisionTriangle> triangles;
  for (const int floor : {2, 0, 3, 1}) AddSquare(triangles, -floor, floor);
  const TriangleEngine dut(triangles);
  for (const double length : {3.5, 20.0}) {  // as a packet, and as a walk
    CastMemory memory;
    SegmentQuery query = Down(length);
    query.hit_rule = HitRule::kAll;
    const SegmentHit hit = Cast(dut, query, memory);
    EXPECT_EQ(hit.object, 0);
    const size_t expected = length > 4 ? 4 : 3;  // floors at 1, 2, 3 and 4 m below the start
    ASSERT_EQ(memory.all.size(), expected);
    for (size_t i = 0; i < expected; ++i) {
      EXPECT_EQ(memory.all[i].query, 0);
      EXPECT_EQ(memory.all[i].hit.object, static_cast<int>(i));
      EXPECT_NEAR(memory.all[i].hit.range, 1.0 + static_cast<double>(i), 1e-12);
    }
  }
}

TEST_F(EngineOfOneSquare, HighestFrontOfARisingLineIsAFrontSeenFromItsStart) {
  std::vector<CollisionTriangle> triangles = Square(1);  // faces up: its back is seen from below
  AddSquare(triangles, 2, 1);
  for (size_t i = 2; i < 4; ++i) std::swap(triangles[i].corner[0], triangles[i].corner[1]);
  AddSquare(triangles, 3, 2);
  const TriangleEngine dut(triangles);
  for (const double length : {3.9, 30.0}) {
    CastMemory memory;
    const SegmentHit hit = Cast(dut,
                                {.start = {0.3, 0.2, 0},
                                 .direction = Vector3d::UnitZ(),
                                 .length = length,
                                 .class_mask = kClass,
                                 .hit_rule = HitRule::kHighest,
                                 .face_rule = FaceRule::kFrontOnly},
                                memory);
    ASSERT_TRUE(hit.hit);
    EXPECT_EQ(hit.object, 1);  // the only one that looks down
  }
}

TEST_F(EngineOfOneSquare, ARebuiltWorldIsSeenByReadersThatKnewTheOldOne) {
  TriangleEngine dut(Square(0));
  CastMemory memory;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(Cast(dut, Down(2), memory).range, 1, 1e-12);
  dut.Rebuild(Square(-0.5));
  EXPECT_NEAR(Cast(dut, Down(2), memory).range, 1.5, 1e-12);
  dut.Rebuild({});
  EXPECT_FALSE(Cast(dut, Down(2), memory).hit);
}

TEST_F(EngineOfOneSquare, TooMuchAroundIsWalkedInstead) {
  // More blocks within half a metre than the list takes.
  std::vector<CollisionTriangle> triangles;
  SeededNumbers numbers(17);
  while (triangles.size() < size_t{2} * Surroundings::kMaxBlocks * kBlockSize) {
    const Vector3d corner = numbers.InBox(0.4) - Vector3d(0, 0, 2);
    triangles.push_back(
        {{corner, corner + numbers.InBox(0.001), corner + numbers.InBox(0.001)}, kClass, 1});
  }
  AddSquare(triangles, 0, 0);
  const TriangleEngine dut(triangles);
  CastMemory memory;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(Cast(dut, Down(3), memory).range, 1, 1e-12);
  EXPECT_FALSE(memory.surroundings.usable());
}

}  // namespace
}  // namespace eod::sim
