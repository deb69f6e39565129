#include "sim/segments/triangle_choice.h"

#include "sim/segments/exact_test.h"

namespace eod::sim {

void TriangleChoice::Offer(const BlockTree& tree, size_t block, int place, int query,
                           CastMemory& memory) {
  ++memory.counters.exact;
  const ExactTriangle& exact = tree.triangles[block * kBlockSize + static_cast<size_t>(place)];
  const Eigen::Vector3d* corner = &tree.vertices[tree.places[block].first_vertex];
  const std::optional<double> range =
      Meet(*query_, corner[exact.vertex[0]], corner[exact.vertex[1]], corner[exact.vertex[2]]);
  if (!range) return;
  if (query_->hit_rule == HitRule::kAll) {
    HitAt(tree, block, place, *range, memory.all.emplace_back(ListedHit{query, {}}).hit);
  }
  const HitOrder order{Rank(*query_, *range), tree.surfaces[exact.surface].object, exact.triangle};
  if (found() && !order.IsBefore(order_)) return;
  order_ = order;
  range_ = *range;
  block_ = block;
  place_ = place;
}

void TriangleChoice::Answer(const BlockTree& tree, SegmentHit& hit) const {
  HitAt(tree, block_, place_, range_, hit);
}

void TriangleChoice::HitAt(const BlockTree& tree, size_t block, int place, double range,
                           SegmentHit& hit) const {
  const ExactTriangle& exact = tree.triangles[block * kBlockSize + static_cast<size_t>(place)];
  const Eigen::Vector3d* corner = &tree.vertices[tree.places[block].first_vertex];
  const Eigen::Vector3d& a = corner[exact.vertex[0]];
  const Surface& surface = tree.surfaces[exact.surface];
  hit.hit = true;
  hit.point = query_->start + range * query_->direction;
  hit.normal = (corner[exact.vertex[1]] - a).cross(corner[exact.vertex[2]] - a).normalized();
  hit.range = range;
  hit.object = surface.object;
  hit.object_class = surface.class_mask;
  hit.triangle = exact.triangle;
}

}  // namespace eod::sim
