// That the benchmark measures what it says, on its smallest scene; no clocks.

#include <bit>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/bench/isector_bench/indexed_mesh.h"
#include "tests/bench/isector_bench/site.h"
#include "tests/bench/isector_bench/workload.h"
#include "tests/reference/double_tree.h"

namespace eod::bench {
namespace {

constexpr int kFrames = 2000;

class Workload : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scene_ = new Scene(MakeScene(10000));
    path_ = new std::vector<RobotPose>(DrivePath(kFrames));
    tree_ = new reference::DoubleTree(scene_->module.triangles);
  }
  static void TearDownTestSuite() {
    delete scene_;
    delete path_;
    delete tree_;
  }
  static double HitShare(std::span<const sim::SegmentQuery> lines, auto&& selected) {
    int asked = 0, hit = 0;
    for (const sim::SegmentQuery& line : lines) {
      if (!selected(line)) continue;
      ++asked;
      if (tree_->Cast(line).triangle >= 0) ++hit;
    }
    return static_cast<double>(hit) / asked;
  }
  static inline Scene* scene_;
  static inline std::vector<RobotPose>* path_;
  static inline reference::DoubleTree* tree_;
};

TEST_F(Workload, AFrameIsThreeLegsAndTenBumpsOfSix) {
  const auto lines = ShortLines(*path_);
  ASSERT_EQ(lines.size(), kFrames * 63u);
  for (size_t i = 0; i < lines.size(); ++i) {
    const size_t in_frame = i % 63;
    EXPECT_EQ(lines[i].length, in_frame < 3 ? 2 : 0.3);
    EXPECT_EQ(lines[i].group, in_frame < 3 ? 0 : 1 + (in_frame - 3) / 6);
    EXPECT_NEAR(lines[i].direction.norm(), 1, 1e-12);
    if (in_frame < 3) {
      EXPECT_EQ(lines[i].direction, -Eigen::Vector3d::UnitZ());
    }
  }
}

TEST_F(Workload, BumpsLookBothWaysAlongTheirOwnAxes) {
  const auto lines = ShortLines(*path_);
  for (size_t i = 3; i < lines.size(); i += i % 63 == 61 ? 5 : 2) {
    EXPECT_EQ(lines[i].start, lines[i + 1].start);
    EXPECT_EQ(lines[i].direction, -lines[i + 1].direction);
  }
}

TEST_F(Workload, TheRobotDrivesOnceRoundFarFromTheOrigin) {
  const double step = kSpeed / kFrameRate;
  for (size_t i = 1; i < path_->size(); ++i) {
    const Eigen::Vector3d moved =
        (*path_)[i].X_MR.translation() - (*path_)[i - 1].X_MR.translation();
    EXPECT_NEAR(moved.head<2>().norm(), step, 1e-4);
    EXPECT_NEAR((*path_)[i].X_MR.translation().norm(), 1700, 15);
  }
  const Eigen::Vector3d gap = path_->front().X_MR.translation() - path_->back().X_MR.translation();
  EXPECT_LT(gap.head<2>().norm(), 1.1 * step);
}

TEST_F(Workload, HitsAreThoseOfARobotAmongThings) {
  const auto lines = ShortLines(*path_);
  EXPECT_EQ(HitShare(lines, [](const auto& line) { return line.group == 0; }), 1);
  const double bumps = HitShare(lines, [](const auto& line) { return line.group != 0; });
  EXPECT_GT(bumps, 0.12);
  EXPECT_LT(bumps, 0.27);
  const double all = HitShare(lines, [](const auto&) { return true; });
  EXPECT_GT(all, 0.15);
  EXPECT_LT(all, 0.30);
  for (uint32_t bump = 1; bump <= kBumps; ++bump) {
    EXPECT_GT(HitShare(lines, [=](const auto& line) { return line.group == bump; }), 0) << bump;
  }
}

TEST_F(Workload, SightLinesAreEightOf200Metres) {
  const auto lines = SightLines(*path_);
  ASSERT_EQ(lines.size(), kFrames * 8u);
  for (size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].length, 200);
    EXPECT_EQ(lines[i].group, 11 + i % 8);
    EXPECT_LT(std::abs(std::asin(lines[i].direction.z())), 0.053);
  }
  const double share = HitShare(lines, [](const auto&) { return true; });
  EXPECT_GT(share, 0.4);
  EXPECT_LT(share, 1.0);
}

TEST_F(Workload, NothingPassesWhatAimedLinesAimAt) {
  const auto lines = AimedLines(*scene_, *path_);
  ASSERT_EQ(lines.size(), 6000u);
  EXPECT_EQ(HitShare(lines, [](const auto&) { return true; }), 1);
}

TEST_F(Workload, TheReferenceIsBruteForce) {
  const auto same = [](const std::vector<sim::SegmentQuery>& lines, size_t stride) {
    for (size_t i = 0; i < lines.size(); i += stride) {
      const auto slow = reference::TryEveryTriangle(scene_->module.triangles, lines[i]);
      const auto quick = tree_->Cast(lines[i]);
      ASSERT_EQ(quick.triangle, slow.triangle) << i;
      ASSERT_EQ(quick.range, slow.range) << i;
    }
  };
  same(ShortLines(*path_), 31);
  same(SightLines(*path_), 17);
  same(AimedLines(*scene_, *path_), 7);
}

/// All bits of the corners.
uint64_t Digest(const Scene& scene) {
  uint64_t digest = 0;
  for (const sim::CollisionTriangle& triangle : scene.module.triangles) {
    for (const Eigen::Vector3d& corner : triangle.corner) {
      for (const double value : corner) {
        digest = (digest ^ std::bit_cast<uint64_t>(value)) * 0x9E3779B97F4A7C15u;
        digest ^= digest >> 29;
      }
    }
  }
  return digest;
}

TEST_F(Workload, SameSizeSameBits) {
  EXPECT_EQ(Digest(*scene_), Digest(MakeScene(10000)));
  const auto once = ShortLines(*path_), again = ShortLines(DrivePath(kFrames));
  for (size_t i = 0; i < once.size(); ++i) {
    ASSERT_EQ(once[i].start, again[i].start);
    ASSERT_EQ(once[i].direction, again[i].direction);
  }
  const auto aimed = AimedLines(*scene_, *path_), aimed_again = AimedLines(*scene_, *path_);
  for (size_t i = 0; i < aimed.size(); ++i) ASSERT_EQ(aimed[i].start, aimed_again[i].start);
}

TEST(Scenes, HaveAsManyTrianglesAsAskedFor) {
  for (const int64_t triangles : {10000, 12345, 100000}) {
    EXPECT_EQ(static_cast<int64_t>(MakeScene(triangles).module.triangles.size()), triangles);
  }
  EXPECT_THROW(MakeScene(9999), std::invalid_argument);
}

TEST(Scenes, GrowInAreaAndInDensity) {
  const Scene small = MakeScene(10000), large = MakeScene(100000);
  EXPECT_DOUBLE_EQ(small.terrain_density, 8);
  EXPECT_DOUBLE_EQ(large.terrain_density, 16);
  EXPECT_NEAR(large.terrain_size.prod() / small.terrain_size.prod(), 5, 0.8);
  // The site is the same at every size, and inside the terrain.
  EXPECT_GT(small.terrain_size.minCoeff() / 2, std::hypot(kLoopU, kLoopV));
}

TEST(IndexedMeshes, ShareCornersAndKeepTriangles) {
  const Scene scene = MakeScene(10000);
  const IndexedMesh dut = MakeIndexed(scene.module.triangles);
  ASSERT_EQ(dut.triangles.size(), scene.module.triangles.size());
  EXPECT_LT(dut.corners.size(), 0.7 * static_cast<double>(dut.triangles.size()));
  for (size_t i = 0; i < dut.triangles.size(); ++i) {
    for (size_t k = 0; k < 3; ++k)
      ASSERT_EQ(dut.corners[dut.triangles[i][k]], scene.module.triangles[i].corner[k]);
  }
}

}  // namespace
}  // namespace eod::bench
