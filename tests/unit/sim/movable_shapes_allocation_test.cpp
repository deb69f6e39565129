#include <vector>

#include <gtest/gtest.h>

#include "sim/segments/movable_shapes.h"
#include "tests/unit/counting_new.h"
#include "tests/unit/sim/random_scene.h"

namespace eod::sim {
namespace {

TEST(MovableShapesAllocation, CastingAndMovingAllocateNothingOnceTheMemoryHasGrown) {
  SeededNumbers numbers(81);
  MovableShapes dut;
  std::vector<Eigen::Isometry3d> poses;
  for (int i = 0; i < 50; ++i) {
    poses.emplace_back(Eigen::Translation3d(numbers.InBox(1)));
    dut.Add(i, kMovableObject, i % 2 == 0 ? Shape::Sphere(0.3) : Shape::Box({0.2, 0.4, 0.6}),
            poses.back());
  }
  std::vector<SegmentQuery> queries(500);
  for (size_t i = 0; i < queries.size(); ++i) {
    queries[i] = {.start = numbers.InBox(1),
                  .direction = numbers.InBox(1).normalized(),
                  .length = 1,
                  .class_mask = kMovableObject,
                  .hit_rule = i % 2 == 0 ? HitRule::kAll : HitRule::kNearest,
                  .group = static_cast<uint32_t>(i / 6)};
  }
  std::vector<SegmentHit> hits(queries.size());
  CastMemory memory;
  dut.Cast(queries, hits, memory);
  ASSERT_GT(memory.all.size(), 100u);
  const long before = AllocationCount();
  for (int i = 0; i < 10; ++i) {
    memory.all.clear();
    dut.Move(i, poses[static_cast<size_t>(i)]);
    dut.Cast(queries, hits, memory);
  }
  EXPECT_EQ(AllocationCount(), before);
}

}  // namespace
}  // namespace eod::sim
