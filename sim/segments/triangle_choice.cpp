#include "sim/segments/triangle_choice.h"

#include "sim/segments/exact_test.h"
#include "sim/segments/hit_choice.h"

namespace eod::sim {

void TriangleChoice::Offer(const BlockTree& tree, size_t block, int place, int query,
                           CastMemory& memory) {
  ++memory.counters.exact;
  const Triangle corner = tree.Corners(block, place);
  const std::optional<double> range = Meet(*query_, corner[0], corner[1], corner[2]);
  if (!range) return;
  if (query_->hit_rule == HitRule::kAll) {
    memory.all.push_back({query, HitAt(tree, block, place, *range)});
  }
  const double rank = Rank(*query_, *range);
  const Surface& surface = tree.SurfaceOf(block, place);
  const int triangle = tree.triangles[block * kBlockSize + static_cast<size_t>(place)].triangle;
  const bool better = !found() || rank < rank_ ||
                      (rank == rank_ && (surface.object != object_ ? surface.object < object_
                                                                   : triangle < triangle_));
  if (!better) return;
  rank_ = rank;
  range_ = *range;
  object_ = surface.object;
  triangle_ = triangle;
  block_ = block;
  place_ = place;
}

SegmentHit TriangleChoice::Hit(const BlockTree& tree) const {
  return found() ? HitAt(tree, block_, place_, range_) : SegmentHit{};
}

SegmentHit TriangleChoice::HitAt(const BlockTree& tree, size_t block, int place,
                                 double range) const {
  const auto [a, b, c] = tree.Corners(block, place);
  const Surface& surface = tree.SurfaceOf(block, place);
  return {.hit = true,
          .point = query_->start + range * query_->direction,
          .normal = (b - a).cross(c - a).normalized(),
          .range = range,
          .object = surface.object,
          .object_class = surface.class_mask,
          .triangle = tree.triangles[block * kBlockSize + static_cast<size_t>(place)].triangle};
}

}  // namespace eod::sim
