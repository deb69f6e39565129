#include "sim/segments/movable_shapes.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "sim/segments/hit_choice.h"
#include "tests/unit/sim/random_scene.h"

namespace eod::sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr uint32_t kBomb = kBombObject | kModuleBomb;

Isometry3d At(const Vector3d& p_MO) { return Isometry3d(Eigen::Translation3d(p_MO)); }

Isometry3d RandomPose(SeededNumbers& numbers, double half) {
  Isometry3d X_MO = At(numbers.InBox(half));
  X_MO.rotate(Eigen::AngleAxisd(numbers.Between(0, 3), numbers.InBox(1).normalized()));
  return X_MO;
}

SegmentHit CastOne(const MovableShapes& dut, const SegmentQuery& query) {
  SegmentHit hit;
  CastMemory memory;
  dut.Cast({&query, 1}, {&hit, 1}, memory);
  return hit;
}

const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();

TEST(MovableShapes, AreMetWhereTheyStandNow) {
  MovableShapes dut;
  dut.Add(7, kMovableObject, Shape::Box({1, 1, 1}), At({0, 5, 0}));
  const SegmentQuery query{.direction = kY, .length = 20, .class_mask = kMovableObject};
  EXPECT_NEAR(CastOne(dut, query).range, 4.5, 1e-15);
  // Turned by 45 degrees about Z: the edge looks at the segment.
  Isometry3d X_MO = At({0, 8, 0});
  X_MO.rotate(Eigen::AngleAxisd(M_PI / 4, kZ));
  EXPECT_TRUE(dut.Move(7, X_MO));
  EXPECT_NEAR(CastOne(dut, query).range, 8 - std::sqrt(0.5), 1e-12);
  EXPECT_FALSE(dut.Move(8, X_MO));
  EXPECT_TRUE(dut.Remove(7));
  EXPECT_FALSE(CastOne(dut, query).hit);
  EXPECT_FALSE(dut.Remove(7));
}

TEST(MovableShapes, ShapesOfOneObjectMoveTogether) {
  MovableShapes dut;  // a dumb-bell along Y
  dut.Add(1, kMovableObject, Shape::Sphere(0.5), At({0, 5, 0}), At({0, -1, 0}));
  dut.Add(1, kMovableObject, Shape::Sphere(0.25), At({0, 5, 0}), At({0, 1, 0}));
  const SegmentQuery query{.direction = kY, .length = 20, .class_mask = kMovableObject};
  EXPECT_NEAR(CastOne(dut, query).range, 3.5, 1e-15);
  Isometry3d X_MO = At({0, 5, 0});
  X_MO.rotate(Eigen::AngleAxisd(M_PI, kZ));  // the other end first
  dut.Move(1, X_MO);
  EXPECT_NEAR(CastOne(dut, query).range, 3.75, 1e-15);
  dut.Remove(1);
  EXPECT_EQ(dut.size(), 0u);
}

TEST(MovableShapes, MasksDecideWhatIsMet) {
  MovableShapes dut;
  dut.Add(1, kBomb, Shape::Sphere(0.5), At({0, 5, 0}));
  SegmentQuery query{.direction = kY, .length = 20, .class_mask = kBombObject};
  EXPECT_TRUE(CastOne(dut, query).hit);
  query.class_mask = kBombObject | kModuleFlat;  // another module's bomb
  EXPECT_FALSE(CastOne(dut, query).hit);
  query.class_mask = kMovableObject;
  EXPECT_FALSE(CastOne(dut, query).hit);
  query.class_mask = 0;
  EXPECT_FALSE(CastOne(dut, query).hit);
}

TEST(MovableShapes, FrontFacesAreEntriesAlone) {
  MovableShapes dut;
  dut.Add(1, kBomb, Shape::Sphere(0.5), At({0, 5, 0}));
  SegmentQuery query{.start = {0, 5, 0},
                     .direction = kY,
                     .length = 20,
                     .class_mask = kBombObject,
                     .face_rule = FaceRule::kFrontOnly};
  EXPECT_FALSE(CastOne(dut, query).hit);  // from inside
  query.start = Vector3d::Zero();
  EXPECT_NEAR(CastOne(dut, query).range, 4.5, 1e-15);
}

/// Three storeys: boxes of 0.2 m height with their middles at z = 1, 2, 3.
MovableShapes Storeys() {
  MovableShapes shapes;
  for (int i = 1; i <= 3; ++i) {
    shapes.Add(i, kMovableObject, Shape::Box({4, 4, 0.2}), At({0, 0, static_cast<double>(i)}));
  }
  return shapes;
}

TEST(MovableShapes, HighestFrontOfARisingLineIsItsLastEntry) {
  const MovableShapes dut = Storeys();
  SegmentQuery query{.direction = kZ,
                     .length = 5,
                     .class_mask = kMovableObject,
                     .hit_rule = HitRule::kHighest,
                     .face_rule = FaceRule::kFrontOnly};
  EXPECT_NEAR(CastOne(dut, query).range, 2.9, 1e-15);  // the underside of the top storey
  query.face_rule = FaceRule::kTwoSided;
  EXPECT_NEAR(CastOne(dut, query).range, 3.1, 1e-15);
  query.length = 3;  // ends within the top storey
  EXPECT_NEAR(CastOne(dut, query).range, 2.9, 1e-15);
  query.start = {0, 0, 5};
  query.direction = -kZ;
  query.length = 5;
  EXPECT_NEAR(CastOne(dut, query).point.z(), 3.1, 1e-15);
  query.hit_rule = HitRule::kNearest;
  query.start = {0, 0, 0};
  query.direction = kZ;
  EXPECT_NEAR(CastOne(dut, query).range, 0.9, 1e-15);
}

TEST(MovableShapes, AllHitsAreListedByRange) {
  const MovableShapes dut = Storeys();
  const std::array<SegmentQuery, 3> queries = {
      SegmentQuery{.start = {0, 0, 5},
                   .direction = -kZ,
                   .length = 5,
                   .class_mask = kMovableObject,
                   .hit_rule = HitRule::kAll},
      SegmentQuery{.direction = kZ, .length = 5, .class_mask = kMovableObject},
      SegmentQuery{.start = {0, 0, 2},
                   .direction = kZ,
                   .length = 5,
                   .class_mask = kMovableObject,
                   .hit_rule = HitRule::kAll,
                   .face_rule = FaceRule::kFrontOnly}};
  std::array<SegmentHit, 3> hits;
  CastMemory memory;
  // What triangles have left there before.
  memory.all.push_back({0, {.hit = true, .range = 2.05, .object = 9, .triangle = 4}});
  memory.all.push_back({2, {.hit = true, .range = 0.5, .object = 9, .triangle = 5}});
  dut.Cast(queries, hits, memory);
  std::vector<std::pair<int, double>> listed;
  for (const ListedHit& one : memory.all) listed.emplace_back(one.query, one.hit.range);
  const std::vector<std::pair<int, double>> expected = {
      {0, 1.9}, {0, 2.05}, {0, 2.1}, {0, 2.9}, {0, 3.1}, {0, 3.9}, {0, 4.1}, {2, 0.5}, {2, 0.9}};
  ASSERT_EQ(listed.size(), expected.size());
  for (size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(listed[i].first, expected[i].first);
    EXPECT_NEAR(listed[i].second, expected[i].second, 1e-12);
  }
  EXPECT_NEAR(hits[0].range, 1.9, 1e-12);  // the nearest, besides
  EXPECT_NEAR(hits[2].range, 0.9, 1e-12);
}

TEST(MovableShapes, HitOfATriangleStaysUnlessAShapeIsPreferred) {
  MovableShapes dut;
  dut.Add(5, kMovableObject, Shape::Box({1, 1, 1}), At({0, 2, 0}));
  const SegmentQuery query{.direction = kY, .length = 9, .class_mask = kMovableObject};
  CastMemory memory;
  const auto merged = [&](double range, int object) {
    SegmentHit hit{.hit = true, .range = range, .object = object, .triangle = 8};
    dut.Cast({&query, 1}, {&hit, 1}, memory);
    return hit.object;
  };
  EXPECT_EQ(merged(1.4, 9), 9);  // nearer than the face at 1.5
  EXPECT_EQ(merged(1.6, 9), 5);
  EXPECT_EQ(merged(1.5, 9), 5);  // a tie: the lower number
  EXPECT_EQ(merged(1.5, 2), 2);
}

TEST(MovableShapes, NoGroupAndNoCullChangesAnAnswer) {
  SeededNumbers numbers(51);
  MovableShapes dut;
  std::vector<MovableShapes> alone(100);
  for (int i = 0; i < 100; ++i) {
    const double size = numbers.Between(0.1, 1);
    const Shape shape = i % 4 == 0   ? Shape::Box({size, 1, 0.5})
                        : i % 4 == 1 ? Shape::Cylinder(size / 2, 1)
                        : i % 4 == 2 ? Shape::Sphere(size / 2)
                                     : Shape::Capsule(size / 4, size);
    const uint32_t kind = i % 3 == 0 ? kBomb : uint32_t{kMovableObject};
    const Isometry3d X_MO = RandomPose(numbers, 4);
    dut.Add(i, kind, shape, RandomPose(numbers, 4));
    dut.Move(i, X_MO);
    alone[static_cast<size_t>(i)].Add(i, kind, shape, X_MO);
  }
  std::vector<SegmentQuery> queries;
  for (size_t i = 0; i < 20000; ++i) {
    const size_t group = i / 6;
    queries.push_back({.start = i % 6 == 0 ? numbers.InBox(4) : queries.back().start,
                       .direction = numbers.InBox(1).normalized(),
                       .length = numbers.Between(0, 6),
                       .class_mask = group % 5 == 0 ? kBombObject : kBombObject | kMovableObject,
                       .hit_rule = i % 7 == 0 ? HitRule::kHighest : HitRule::kNearest,
                       .group = static_cast<uint32_t>(group)});
  }
  std::vector<SegmentHit> hits(queries.size());
  CastMemory memory, other;
  dut.Cast(queries, hits, memory);
  size_t met = 0;
  for (size_t i = 0; i < queries.size(); ++i) {
    SegmentHit expected;  // one shape after the other, each alone in its list
    for (const MovableShapes& one : alone) one.Cast({&queries[i], 1}, {&expected, 1}, other);
    ASSERT_EQ(hits[i].hit, expected.hit);
    ASSERT_EQ(hits[i].object, expected.object);
    ASSERT_EQ(hits[i].range, expected.range);
    met += hits[i].hit;
  }
  EXPECT_GT(met, queries.size() / 10);
  EXPECT_LT(memory.counters.candidates, queries.size() * 10);  // of 100 shapes each
}

TEST(MovableShapes, LeaveQueriesAloneThatCannotBeCast) {
  MovableShapes dut;
  dut.Add(1, kMovableObject, Shape::Sphere(1), At(Vector3d::Zero()));
  const double nan = std::nan("");
  const SegmentQuery good{.direction = kY, .length = 9, .class_mask = kMovableObject};
  std::array<SegmentQuery, 6> queries;
  queries.fill(good);
  queries[0].start.x() = nan;
  queries[1].direction = 2 * kY;
  queries[2].length = -1;
  queries[3].length = INFINITY;
  queries[4].direction = Vector3d::Constant(nan);
  std::array<SegmentHit, 6> hits;
  CastMemory memory;
  dut.Cast(queries, hits, memory);
  for (size_t i = 0; i < 5; ++i) EXPECT_FALSE(hits[i].hit) << i;
  EXPECT_TRUE(hits[5].hit);  // of the same group, and not spoilt by the others
  EXPECT_EQ(memory.counters.candidates, 1u);
}

TEST(MovableShapes, ThreadsReadTogether) {
  SeededNumbers numbers(52);
  MovableShapes dut;
  for (int i = 0; i < 40; ++i) {
    dut.Add(i, kMovableObject, Shape::Capsule(0.2, 0.5), RandomPose(numbers, 2));
  }
  std::vector<SegmentQuery> queries;
  for (size_t i = 0; i < 3000; ++i) {
    queries.push_back({.start = numbers.InBox(2),
                       .direction = numbers.InBox(1).normalized(),
                       .length = 1,
                       .class_mask = kMovableObject});
  }
  std::vector<SegmentHit> expected(queries.size());
  CastMemory memory;
  dut.Cast(queries, expected, memory);
  std::atomic<int> different = 0;
  std::vector<std::thread> readers;
  for (int reader = 0; reader < 4; ++reader) {
    readers.emplace_back([&] {
      std::vector<SegmentHit> hits(queries.size());
      CastMemory own;
      dut.Cast(queries, hits, own);
      for (size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].range != expected[i].range || hits[i].object != expected[i].object) ++different;
      }
    });
  }
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(different, 0);
}

TEST(HitChoice, BothEndsOfASegmentCountToTheTolerance) {
  EXPECT_EQ(OnSegment(0.5, 1), 0.5);
  EXPECT_EQ(OnSegment(-0.5e-9, 1), 0.0);
  EXPECT_EQ(OnSegment(1 + 0.5e-9, 1), 1.0);
  EXPECT_EQ(OnSegment(-2e-9, 1), std::nullopt);
  EXPECT_EQ(OnSegment(1 + 2e-9, 1), std::nullopt);
  EXPECT_EQ(OnSegment(std::nan(""), 1), std::nullopt);
  EXPECT_FALSE(std::signbit(*OnSegment(-0.0, 1)));
}

TEST(HitChoice, OfALevelLineTheNearestIsTheHighest) {
  const SegmentQuery level{.direction = kX, .hit_rule = HitRule::kHighest};
  const SegmentHit near{.hit = true, .range = 1, .object = 4}, far{.hit = true, .range = 2};
  EXPECT_TRUE(IsPreferred(level, near, far));
  EXPECT_FALSE(IsPreferred(level, far, near));
}

}  // namespace
}  // namespace eod::sim
