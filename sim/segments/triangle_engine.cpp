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
    hits[i] = SegmentHit{};
    if (!IsCastable(queries[i])) {
      ++memory.counters.rejected;
      ++i;
    } else if (!IsShort(queries[i])) {
      CastLong(queries[i], i, hits[i], memory);
      ++i;
    } else {
      size_t end = i + 1;
      while (end < queries.size() && end < i + kLanes && GoTogether(queries[i], queries[end]) &&
             IsShort(queries[end]) && IsCastable(queries[end])) {
        hits[end++] = SegmentHit{};
      }
      CastShort(queries, i, end, hits, memory);
      i = end;
    }
  }
  if (!memory.all.empty()) SortListed(memory);
}

void TriangleEngine::CastLong(const SegmentQuery& query, size_t index, SegmentHit& hit,
                              CastMemory& memory) const {
  TriangleChoice choice(query);
  WalkAlong(tree_, *kernels_, query, static_cast<int>(index), choice, memory);
  hit = choice.Hit(tree_);
}

void TriangleEngine::CastShort(std::span<const SegmentQuery> queries, size_t first, size_t end,
                               std::span<SegmentHit> hits, CastMemory& memory) const {
  Surroundings& near = memory.surroundings;
  const auto group = queries.subspan(first, end - first);
  bool covered = false;
  if (near.IsOf(revision_)) {
    const PacketCast packet(group, static_cast<int>(first), near.origin());
    covered = near.Covers(packet.packet());
    if (covered && near.usable()) {
      packet.Run(tree_, *kernels_, memory, hits.subspan(first));
      return;
    }
  }
  if (!covered && near.IsWorthGathering(BoxOfShort(group))) {
    near.Gather(tree_, *kernels_, BoxOfShort(queries), revision_);
    ++memory.counters.refills;
    CastShort(queries, first, end, hits, memory);
    return;
  }
  for (size_t i = first; i < end; ++i) CastLong(queries[i], i, hits[i], memory);
}

}  // namespace eod::sim
