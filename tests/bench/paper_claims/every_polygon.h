#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/segments/block_tree.h"
#include "sim/world/world.h"

namespace eod::claims {

/// A world without any tree: every polygon that the class mask lets through is a candidate of every
/// segment, as in a traversal that knows masks alone. Each is decided by the product's exact test.
class EveryPolygon final : public sim::World {
 public:
  /// `triangles` must outlive the world.
  explicit EveryPolygon(std::span<const sim::CollisionTriangle> triangles)
      : triangles_(triangles) {}

  /// Counts segments, candidates and exact tests; there are no blocks.
  void Cast(std::span<const sim::SegmentQuery> queries, std::span<sim::SegmentHit> hits,
            sim::CastMemory& memory) const override;
  /// Objects have no names here.
  const std::string& ObjectName(int object) const override;

 private:
  std::span<const sim::CollisionTriangle> triangles_;
};

}  // namespace eod::claims
