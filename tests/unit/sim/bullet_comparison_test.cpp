#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "sim/segments/exact_test.h"
#include "tests/unit/sim/bullet_scene.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

constexpr int kSegments = 50000;
// Both worlds calculate in double, with coordinates up to 20 m; a line that grazes a triangle
// magnifies roundings of 1e-15 m by what it is flatter than upright, thousands of times at most
// here.
constexpr double kRounding = 1e-10;

/// Half of them into the blue, half at some triangle; of all rules.
SegmentQuery RandomQuery(const ModuleModel& module, SeededNumbers& numbers) {
  const auto& [a, b, c] = module.triangles[numbers.Below(module.triangles.size())].corner;
  const Vector3d target = numbers.Below(2) == 0 ? numbers.InBox(20) : Vector3d((a + b + c) / 3);
  SegmentQuery query{
      .start = numbers.InBox(20),
      .length = numbers.Below(2) == 0 ? numbers.Between(1, 40) : numbers.Between(0.05, 1),
      .class_mask = kModuleFlat | kBumpProxy};
  query.direction = (target - query.start).normalized();
  const size_t kind = numbers.Below(6);
  if (kind == 0) query.class_mask = kModuleFlat | kClampProxy;
  if (kind == 1) query.direction = Vector3d::Unit(static_cast<int>(numbers.Below(3)));
  if (kind == 2) query.hit_rule = HitRule::kHighest;
  if (kind == 3) query.face_rule = FaceRule::kFrontOnly;
  return query;
}

/// Whether the hit is one of those that Bullet finds a little outside of a triangle.
bool BeyondTheEdge(const ModuleModel& module, const SegmentQuery& query, const SegmentHit& hit) {
  const auto& [a, b, c] = module.triangles[static_cast<size_t>(hit.triangle)].corner;
  return !Meet(query, a, b, c);
}

TEST(BulletComparison, TrianglesAreMetAlikeOverFiftyThousandSegments) {
  const ModuleModel module = RandomScene(1);
  const std::unique_ptr<World> ours = BuildWorld(module);
  const BulletWorld bullet(module);
  SeededNumbers numbers(61);
  int met = 0, beyond_the_edge = 0;
  for (int i = 0; i < kSegments; ++i) {
    const SegmentQuery query = RandomQuery(module, numbers);
    const SegmentHit hit = CastOne(*ours, query), other = CastOne(bullet, query);
    if (other.hit && BeyondTheEdge(module, query, other)) {
      ++beyond_the_edge;
      continue;
    }
    ASSERT_EQ(hit.hit, other.hit) << i;
    if (!hit.hit) continue;
    ++met;
    ASSERT_EQ(hit.triangle, other.triangle) << i;
    ASSERT_EQ(hit.object, other.object);
    ASSERT_EQ(hit.object_class, other.object_class);
    ASSERT_NEAR(hit.range, other.range, kRounding);
    ASSERT_LT((hit.point - other.point).norm(), kRounding);
    ASSERT_LT((hit.normal - other.normal).norm(), kRounding);
    ASSERT_EQ(ours->ObjectName(hit.object), bullet.ObjectName(other.object));
  }
  EXPECT_GT(met, kSegments / 8);
  // 1e-4 of a triangle lies beyond each of its edges.
  EXPECT_LE(beyond_the_edge, met / 1000);
}

TEST(BulletComparison, SolidsWithFlatFacesAreMetAlikeFromOutside) {
  // Bullet walks towards a solid until it is within a micrometre: its simplex takes vertices for
  // one whose squares differ by 1e-12. Along the line that is as much longer as the line is slant.
  constexpr double kWalk = 1e-6;
  for (const size_t which : {0, 4}) {  // box and hull
    const KnownSolid solid = KnownSolids()[which];
    SeededNumbers numbers(62);
    int met = 0, false_hits = 0;
    for (int pose = 0; pose < 200; ++pose) {
      const SolidInBoth both(solid.shape, {}, numbers);
      for (int i = 0; i < 200; ++i) {
        const SegmentQuery query = both.RandomSegment(numbers);
        if (both.Distance(solid, query.start) <= 0) continue;  // Bullet cannot answer from inside
        const SegmentHit hit = CastOne(both.ours, query), other = CastOne(both.bullet, query);
        if (!hit.hit && other.hit && both.Distance(solid, other.point) > 1e-4) {
          ++false_hits;  // far off the solid: BulletDeviations has their proof
          continue;
        }
        ASSERT_EQ(hit.hit, other.hit) << solid.name;
        if (!hit.hit) continue;
        ++met;
        const double slope = std::abs(hit.normal.dot(query.direction));
        ASSERT_LT(std::abs(hit.range - other.range) * slope, kWalk) << solid.name;
        ASSERT_LT((hit.normal - other.normal).norm(), 100 * kWalk) << solid.name;
        ASSERT_EQ(hit.object, other.object);
        ASSERT_EQ(hit.object_class, other.object_class);
      }
    }
    EXPECT_GT(met, 15000) << solid.name;
    EXPECT_LE(false_hits, met / 200) << solid.name;
  }
}

TEST(BulletComparison, SpheresAndCylindersAreMetAlikeToATenthOfAMillimetre) {
  // Round supports make Bullet converge by steps that shrink by a constant factor, 64 of them at
  // most: there is no bound to state, so the share of good answers is.
  for (const size_t which : {1, 2}) {
    const KnownSolid solid = KnownSolids()[which];
    SeededNumbers numbers(63);
    int met = 0, different = 0, far = 0;
    for (int pose = 0; pose < 200; ++pose) {
      const SolidInBoth both(solid.shape, {}, numbers);
      for (int i = 0; i < 200; ++i) {
        const SegmentQuery query = both.RandomSegment(numbers);
        if (both.Distance(solid, query.start) <= 0) continue;
        const SegmentHit hit = CastOne(both.ours, query), other = CastOne(both.bullet, query);
        met += hit.hit;
        different += hit.hit != other.hit;
        far += hit.hit && other.hit && std::abs(both.Distance(solid, other.point)) > 1e-4;
      }
    }
    EXPECT_GT(met, 4000) << solid.name;
    EXPECT_LE(different, met / 500) << solid.name;
    EXPECT_LE(far, met / 500) << solid.name;
  }
}

/// A convex mesh, and the hull of its corners: one solid in two forms.
struct MeshAndHull {
  const char* name;
  Mesh mesh;
  Shape Hull(double scale) const {
    std::vector<Vector3d> corners;
    for (const Triangle& triangle : mesh) {
      for (const Vector3d& corner : triangle) corners.push_back(scale * corner);
    }
    return Shape::Hull(corners);
  }
};

/// Ranges of all crossings; what is closer together than `merged` is one.
std::vector<double> AllRanges(const World& world, SegmentQuery query, double merged) {
  query.hit_rule = HitRule::kAll;
  SegmentHit hit;
  CastMemory memory;
  world.Cast({&query, 1}, {&hit, 1}, memory);
  std::vector<double> ranges;
  for (const ListedHit& one : memory.all) {
    if (ranges.empty() || one.hit.range - ranges.back() > merged) ranges.push_back(one.hit.range);
  }
  return ranges;
}

class HullAgainstMesh : public ::testing::TestWithParam<size_t> {
 protected:
  MeshAndHull solid_ = std::vector<MeshAndHull>{{"Box", BoxMesh({0.6, 0.25, 0.4})},
                                                {"Prism", CylinderMesh(0.2, 0.4, 24)},
                                                {"Cone", ConeMesh(0.3, 0.5, 16)},
                                                {"Ball", SphereMesh(0.3, 6, 12)}}[GetParam()];
  AnalyticWorld ours_, larger_, smaller_;
  std::unique_ptr<BulletWorld> bullet_;

  void SetUp() override {
    const auto here = Eigen::Isometry3d::Identity();
    ours_.AddShape(solid_.name, kMovableObject, here, solid_.Hull(1));
    larger_.AddShape(solid_.name, kMovableObject, here, solid_.Hull(1.001));
    smaller_.AddShape(solid_.name, kMovableObject, here, solid_.Hull(0.999));
    ModuleModel module;
    AddObject(module, solid_.name, kMovableObject, solid_.mesh);
    bullet_ = std::make_unique<BulletWorld>(module);
  }

  /// Near the outline or with an end near the surface Bullet's edges reach too far.
  bool Doubtful(const SegmentQuery& query) const {
    return AllRanges(larger_, query, 0).size() != AllRanges(smaller_, query, 0).size();
  }
};

TEST_P(HullAgainstMesh, ExitsAndEntriesAreBulletsTriangles) {
  // Where a line passes an edge of two triangles, Bullet finds the plane of one beyond its edge,
  // by 1e-4 of its height (here below 0.6 m): farther along a slant line, by 1e-3 at most.
  constexpr double kEdge = 1e-3;
  SeededNumbers numbers(64);
  int met = 0, inexact = 0;
  for (int i = 0; i < kSegments; ++i) {
    SegmentQuery query{.start = numbers.InBox(i % 2 == 0 ? 0.7 : 0.2),  // odd ones often inside
                       .length = numbers.Between(0, 1.5),
                       .class_mask = kMovableObject};
    query.direction = (numbers.InBox(0.2) - query.start).normalized();
    if (i % 3 == 0) query.hit_rule = HitRule::kHighest;
    if (i % 5 == 0) query.face_rule = FaceRule::kFrontOnly;
    if (Doubtful(query)) continue;
    const std::vector<double> ranges = AllRanges(ours_, query, kEdge);
    const std::vector<double> others = AllRanges(*bullet_, query, kEdge);
    ASSERT_EQ(ranges.size(), others.size()) << i;
    const SegmentHit hit = CastOne(ours_, query), other = CastOne(*bullet_, query);
    ASSERT_EQ(hit.hit, other.hit) << i;
    if (!hit.hit) continue;
    ++met;
    ASSERT_NEAR(hit.range, other.range, kEdge);
    // A hull is exact to 1e-12 of its extent, over lines at any slant.
    if (std::abs(hit.range - other.range) > 1e-9 || (hit.normal - other.normal).norm() > 1e-9)
      ++inexact;
  }
  EXPECT_GT(met, kSegments / 5);
  EXPECT_LE(inexact, met / 100);
}

INSTANTIATE_TEST_SUITE_P(Solids, HullAgainstMesh, ::testing::Range<size_t>(0, 4));

TEST(BulletWorld, MovesAShapeAndTellsNames) {
  ModuleModel module;
  AddObject(module, "ground", kModuleFlat | kBumpProxy, PlaneMesh(40, 40, 2));
  BulletWorld dut(module);
  const int bomb = dut.AddShape(
      "bomb", kBombObject, Eigen::Isometry3d(Eigen::Translation3d(0, 5, 1)), Shape::Sphere(0.5));
  EXPECT_EQ(bomb, 1);
  EXPECT_EQ(dut.ObjectName(0), "ground");
  EXPECT_EQ(dut.ObjectName(bomb), "bomb");
  EXPECT_EQ(dut.ObjectName(2), "");
  const SegmentQuery query{.start = {0, 0, 1}, .length = 20, .class_mask = kBombObject};
  EXPECT_NEAR(CastOne(dut, query).range, 4.5, 1e-6);
  EXPECT_TRUE(dut.Move(bomb, Eigen::Isometry3d(Eigen::Translation3d(0, 8, 1))));
  EXPECT_NEAR(CastOne(dut, query).range, 7.5, 1e-6);
  EXPECT_FALSE(dut.Move(0, Eigen::Isometry3d::Identity()));
}

}  // namespace
}  // namespace eod::sim
