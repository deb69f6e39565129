#include "tests/exactness/scene_check.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/segments/triangle_engine.h"
#include "tests/exactness/scenes.h"

namespace eod::sim {
namespace {

constexpr size_t kBatch = 48;  // segments a cast, as a robot has

bool IsSame(const SegmentHit& one, const SegmentHit& other) {
  return one.hit == other.hit && one.range == other.range && one.triangle == other.triangle &&
         one.point == other.point && one.normal == other.normal && one.object == other.object;
}

bool IsSame(const CastMemory& one, const CastMemory& other) {
  // Not what the exact test had to decide: fused arithmetic lets other near misses through to it.
  const CastCounters &a = one.counters, &b = other.counters;
  return a.segments == b.segments && a.rejected == b.rejected && a.blocks == b.blocks &&
         a.candidates == b.candidates && a.refills == b.refills &&
         std::equal(one.all.begin(), one.all.end(), other.all.begin(), other.all.end(),
                    [](const ListedHit& x, const ListedHit& y) {
                      return x.query == y.query && IsSame(x.hit, y.hit);
                    });
}

/// The engine on one instruction set, and what it answered last.
struct Device {
  TriangleEngine engine;
  CastMemory memory;
  std::vector<SegmentHit> hits;

  Device(const std::vector<CollisionTriangle>& scene, InstructionSet set) : engine(scene, set) {}
  void Cast(std::span<const SegmentQuery> queries) {
    hits.resize(queries.size());
    engine.Cast(queries, hits, memory);
  }
  std::span<const ListedHit> Listed(size_t query) const {
    const auto [first, last] = std::equal_range(
        memory.all.begin(), memory.all.end(), ListedHit{static_cast<int>(query), {}},
        [](const ListedHit& a, const ListedHit& b) { return a.query < b.query; });
    return {first, last};
  }
};

bool IsSegment(const SegmentQuery& query) {
  return query.start.allFinite() && std::isfinite(query.length) && query.length >= 0 &&
         std::abs(query.direction.norm() - 1) < 1e-9;
}

uint64_t CountDifferent(const Device& plain, const Device& best) {
  uint64_t different = 0;
  for (size_t i = 0; i < plain.hits.size(); ++i) {
    if (!IsSame(plain.hits[i], best.hits[i])) ++different;
  }
  return different + (IsSame(plain.memory, best.memory) ? 0 : 1);
}

}  // namespace

Verdict CheckScene(uint64_t seed, size_t count) {
  const std::vector<CollisionTriangle> scene = TrickyScene(seed);
  const std::vector<SegmentQuery> queries = TrickySegments(scene, count, seed);
  Device plain(scene, InstructionSet::kPlain), best(scene, BestInstructionSet());
  Verdict verdict;
  std::vector<ReferenceHit> expected;
  for (size_t first = 0; first < queries.size(); first += kBatch) {
    const std::span batch(&queries[first], std::min(kBatch, queries.size() - first));
    plain.Cast(batch);
    best.Cast(batch);
    verdict.different += CountDifferent(plain, best);
    for (size_t i = 0; i < batch.size(); ++i) {
      expected.clear();  // what is no segment meets nothing
      const bool is_segment = IsSegment(batch[i]);
      if (is_segment) MeetAll(scene, batch[i], expected);
      if (!is_segment) ++verdict.refused;
      Judge(batch[i], best.hits[i], best.Listed(i), expected, verdict);
    }
  }
  // Each refusal is counted, and nothing else is refused.
  verdict.different += best.memory.counters.rejected == verdict.refused ? 0 : 1;
  return verdict;
}

}  // namespace eod::sim
