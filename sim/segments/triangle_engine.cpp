#include "sim/segments/triangle_engine.h"

#include <atomic>

#include "sim/segments/hit_choice.h"
#include "sim/segments/line_walk.h"
#include "sim/segments/packet_cast.h"

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
  for (size_t i = 0; i < queries.size();) {
    size_t end = i;
    while (end < queries.size() && end < i + kLanes && IsShort(queries[end]) &&
           GoTogether(queries[i], queries[end])) {
      hits[end++] = SegmentHit{};
    }
    if (end > i) {
      CastShort(queries, i, end, hits, memory);
      i = end;
    } else {
      CastAlone(queries[i], i, hits[i], memory);
      ++i;
    }
  }
  if (!memory.all.empty()) SortListed(memory);
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
  if (choice.found()) hit = choice.Hit(tree_);
}

void TriangleEngine::CastShort(std::span<const SegmentQuery> queries, size_t first, size_t end,
                               std::span<SegmentHit> hits, CastMemory& memory) const {
  Surroundings& near = memory.surroundings;
  const auto group = queries.subspan(first, end - first);
  bool worth_a_list = !near.IsOf(revision_);
  if (near.IsOf(revision_)) {
    const PacketCast packet(*kernels_, group, static_cast<int>(first), near.origin());
    const bool covered = packet.valid() && near.Covers(packet.packet());
    if (covered && near.usable()) {
      packet.Run(tree_, memory, hits.subspan(first));
      return;
    }
    worth_a_list = packet.valid() && !covered;
  }
  if (const AlignedBox3d box = BoxOfShort(group);
      worth_a_list && !box.isEmpty() && near.IsWorthGathering(box)) {
    near.Gather(tree_, *kernels_, BoxOfShort(queries), revision_);
    ++memory.counters.refills;
    CastShort(queries, first, end, hits, memory);
    return;
  }
  for (size_t i = first; i < end; ++i) CastAlone(queries[i], i, hits[i], memory);
}

}  // namespace eod::sim
