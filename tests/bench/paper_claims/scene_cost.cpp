#include "tests/bench/paper_claims/scene_cost.h"

#include <chrono>
#include <memory>
#include <span>

#include "sim/world/world_model.h"
#include "tests/bench/isector_bench/workload.h"

namespace eod::claims {
namespace {

using Clock = std::chrono::steady_clock;

/// The whole drive, frame after frame.
void CastAll(const sim::World& world, std::span<const sim::SegmentQuery> lines,
             sim::CastMemory& memory) {
  std::vector<sim::SegmentHit> hits(bench::kLinesPerFrame);
  for (size_t first = 0; first < lines.size(); first += bench::kLinesPerFrame) {
    world.Cast(lines.subspan(first, bench::kLinesPerFrame), hits, memory);
  }
}

}  // namespace

SceneCost MeasureSceneCost(int64_t triangles, int frames, int rounds) {
  SceneCost cost{.triangles = triangles, .frames = frames, .drive = {}, .round_ns = {}};
  std::unique_ptr<sim::World> world;
  {
    const bench::Scene scene = bench::MakeScene(triangles);
    cost.path_density = bench::DensityNearPath(scene);
    world = sim::BuildWorld(scene.module);
  }
  const std::vector<sim::SegmentQuery> lines = bench::ShortLines(bench::DrivePath(frames));
  sim::CastMemory memory;
  CastAll(*world, lines, memory);
  cost.drive = memory.counters;
  for (int round = 0; round < rounds; ++round) {
    const Clock::time_point begin = Clock::now();
    CastAll(*world, lines, memory);
    const std::chrono::duration<double, std::nano> took = Clock::now() - begin;
    cost.round_ns.push_back(took.count() / static_cast<double>(lines.size()));
  }
  return cost;
}

}  // namespace eod::claims
