// That the benchmark measures what it says, on its smallest scene; no clocks.

#include <bit>
#include <cmath>
#include <map>
#include <memory>

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
    scene_ = std::make_unique<Scene>(MakeScene(10000));
    tree_ = std::make_unique<reference::DoubleTree>(scene_->module.triangles);
    path_ = DrivePath(kFrames);
  }
  static void TearDownTestSuite() {
    scene_.reset();
    tree_.reset();
    path_.clear();
  }
  /// How many lines hit something, by group, and in all.
  struct Shares {
    std::map<uint32_t, double> of_group;
    double of_all = 0;
  };
  static Shares HitShares(std::span<const sim::SegmentQuery> lines) {
    std::map<uint32_t, int> asked;
    Shares shares;
    for (const sim::SegmentQuery& line : lines) {
      const int hit = tree_->Cast(line).triangle >= 0 ? 1 : 0;
      ++asked[line.group];
      shares.of_group[line.group] += hit;
      shares.of_all += hit / static_cast<double>(lines.size());
    }
    for (auto& [group, share] : shares.of_group) share /= asked[group];
    return shares;
  }
  static inline std::unique_ptr<Scene> scene_;
  static inline std::unique_ptr<reference::DoubleTree> tree_;
  static inline std::vector<RobotPose> path_;
};

TEST_F(Workload, AFrameIsThreeLegsAndTenBumpsOfSix) {
  const auto lines = ShortLines(path_);
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
  const auto lines = ShortLines(path_);
  for (size_t i = 3; i < lines.size(); i += i % 63 == 61 ? 5 : 2) {
    EXPECT_EQ(lines[i].start, lines[i + 1].start);
    EXPECT_EQ(lines[i].direction, -lines[i + 1].direction);
  }
}

TEST_F(Workload, TheRobotDrivesOnceRoundFarFromTheOrigin) {
  const double step = kSpeed / kFrameRate;
  for (size_t i = 1; i < path_.size(); ++i) {
    const Eigen::Vector3d moved = path_[i].X_MR.translation() - path_[i - 1].X_MR.translation();
    EXPECT_NEAR(moved.head<2>().norm(), step, 1e-4);
    EXPECT_NEAR(path_[i].X_MR.translation().norm(), 1700, 15);
  }
  const Eigen::Vector3d gap = path_.front().X_MR.translation() - path_.back().X_MR.translation();
  EXPECT_LT(gap.head<2>().norm(), 1.1 * step);
}

TEST_F(Workload, HitsAreThoseOfARobotAmongThings) {
  const Shares shares = HitShares(ShortLines(path_));
  EXPECT_EQ(shares.of_group.at(0), 1);
  for (uint32_t bump = 1; bump <= kBumps; ++bump) {
    EXPECT_GT(shares.of_group.at(bump), 0.005) << bump;
    EXPECT_LT(shares.of_group.at(bump), 0.5) << bump;
  }
  EXPECT_GT(shares.of_all, 0.15);
  EXPECT_LT(shares.of_all, 0.30);
}

TEST_F(Workload, SightLinesAreEightOf200Metres) {
  const auto lines = SightLines(path_);
  ASSERT_EQ(lines.size(), kFrames * 8u);
  for (size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].length, 200);
    EXPECT_EQ(lines[i].group, 11 + i % 8);
    EXPECT_LT(std::abs(std::asin(lines[i].direction.z())), 0.053);
  }
  const double share = HitShares(lines).of_all;
  EXPECT_GT(share, 0.4);
  EXPECT_LT(share, 0.999);
}

TEST_F(Workload, NothingPassesWhatAimedLinesAimAt) {
  const auto lines = AimedLines(*scene_, path_);
  ASSERT_EQ(lines.size(), 6000u);
  for (const sim::SegmentQuery& line : lines) EXPECT_GE(tree_->Cast(line).triangle, 0);
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
  same(ShortLines(path_), 307);
  same(SightLines(path_), 127);
  same(AimedLines(*scene_, path_), 37);
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
  const auto once = ShortLines(path_), again = ShortLines(DrivePath(kFrames));
  for (size_t i = 0; i < once.size(); ++i) {
    ASSERT_EQ(once[i].start, again[i].start);
    ASSERT_EQ(once[i].direction, again[i].direction);
  }
  const auto aimed = AimedLines(*scene_, path_), aimed_again = AimedLines(*scene_, path_);
  for (size_t i = 0; i < aimed.size(); ++i) ASSERT_EQ(aimed[i].start, aimed_again[i].start);
}

TEST(Scenes, HaveExactlyAsManyTrianglesAsAskedFor) {
  for (const int64_t triangles : {10000, 12345, 50001}) {
    EXPECT_EQ(static_cast<int64_t>(MakeScene(triangles).module.triangles.size()), triangles);
  }
  EXPECT_THROW(MakeScene(9999), std::invalid_argument);
}

TEST(Scenes, GrowInAreaAndInDensity) {
  const Scene small = MakeScene(10000), large = MakeScene(100000);
  EXPECT_DOUBLE_EQ(small.terrain_density, 8);
  EXPECT_DOUBLE_EQ(large.terrain_density, 16);
  EXPECT_NEAR(large.terrain_size.prod() / small.terrain_size.prod(), 5, 0.8);
  // Near the path the site comes on top of the terrain.
  EXPECT_GT(DensityNearPath(small), 8);
  EXPECT_LT(DensityNearPath(small), 16);
  EXPECT_NEAR(DensityNearPath(large) - DensityNearPath(small), 8, 0.5);
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
