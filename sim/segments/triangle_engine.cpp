#include "sim/segments/triangle_engine.h"

#include <algorithm>
#include <atomic>

#include "sim/segments/hit_choice.h"
#include "sim/segments/line_walk.h"
#include "sim/segments/packet_batch.h"

namespace eod::sim {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

namespace {

constexpr size_t kLanes = 8;

uint64_t NextRevision() {
  static std::atomic<uint64_t> revisions{0};
  return ++revisions;
}

bool IsShort(const SegmentQuery& query) { return query.length <= TriangleEngine::kShort; }

bool GoTogether(const SegmentQuery& one, const SegmentQuery& other) {
  return one.group == other.group && one.class_mask == other.class_mask;
}

/// Round all valid short segments of a list: what will be wanted together again.
AlignedBox3d BoxOfShort(std::span<const SegmentQuery> queries) {
  AlignedBox3d box;
  for (const SegmentQuery& query : queries) {
    if (!IsCastable(query) || !IsShort(query)) continue;
    box.extend(query.start);
    box.extend(Vector3d(query.start + query.length * query.direction));
  }
  return box;
}

}  // namespace

TriangleEngine::TriangleEngine(std::span<const CollisionTriangle> triangles,
                               InstructionSet instruction_set)
    : tree_(BuildBlockTree(triangles)),
      kernels_(&KernelsFor(instruction_set)),
      revision_(NextRevision()) {}

void TriangleEngine::Rebuild(std::span<const CollisionTriangle> triangles) {
  tree_ = BuildBlockTree(triangles);
  revision_ = NextRevision();
}

void TriangleEngine::Cast(std::span<const SegmentQuery> queries, std::span<SegmentHit> hits,
                          CastMemory& memory) const {
  memory.counters.segments += queries.size();
  memory.all.clear();
  PacketBatch batch(tree_, *kernels_, queries, hits, memory);
  for (size_t i = 0; i < queries.size();) {
    size_t end = i;
    while (end < queries.size() && end < i + kLanes && IsShort(queries[end]) &&
           GoTogether(queries[i], queries[end])) {
      hits[end++] = SegmentHit{};
    }
    if (end == i || !CastPacket(queries, i, end, batch, memory)) {
      end = std::max(end, i + 1);
      for (size_t one = i; one < end; ++one) CastAlone(queries[one], one, hits[one], memory);
    }
    i = end;
  }
  batch.Run();
  if (!memory.all.empty()) SortListed(memory);
}

std::optional<double> TriangleEngine::LevelGroundIn(const AlignedBox3d& box, uint32_t class_mask,
                                                    CastMemory& memory) const {
  LevelGround& level = memory.level;
  if (!level.Covers(box, class_mask, revision_)) level.Survey(tree_, box, class_mask, revision_);
  return level.z();
}

void TriangleEngine::CastAlone(const SegmentQuery& query, size_t index, SegmentHit& hit,
                               CastMemory& memory) const {
  hit = SegmentHit{};
  if (!IsCastable(query)) {
    ++memory.counters.rejected;
    return;
  }
  TriangleChoice choice(query);
  WalkAlong(tree_, *kernels_, query, static_cast<int>(index), choice, memory);
  if (choice.found()) choice.Answer(tree_, hit);
}

/// False if the queries have to be cast one by one.
bool TriangleEngine::CastPacket(std::span<const SegmentQuery> queries, size_t first, size_t end,
                                PacketBatch& batch, CastMemory& memory) const {
  Surroundings& near = memory.surroundings;
  if (near.IsOf(revision_)) {
    const PacketBatch::Answer answer = batch.Add(first, end);
    if (answer != PacketBatch::Answer::kUncovered) return answer == PacketBatch::Answer::kAdded;
  }
  const AlignedBox3d box = BoxOfShort(queries.subspan(first, end - first));
  if (box.isEmpty() || !near.IsWorthGathering(box)) return false;
  batch.Run();
  near.Gather(tree_, *kernels_, BoxOfShort(queries), revision_);
  ++memory.counters.refills;
  return near.usable() && batch.Add(first, end) == PacketBatch::Answer::kAdded;
}

}  // namespace eod::sim
