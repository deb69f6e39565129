#pragma once

#include "sim/segments/block_tree.h"
#include "sim/segments/cast_memory.h"

namespace eod::sim {

/// The triangle that answers a query, as far as triangles have been looked at. Does not depend on
/// the order in which they come: see IsPreferred.
class TriangleChoice {
 public:
  TriangleChoice() = default;
  explicit TriangleChoice(const SegmentQuery& query) : query_(&query) {}

  /// Decides a candidate, of a class that the query looks for, exactly and keeps it if the query's
  /// rules prefer it.
  void Offer(const BlockTree& tree, size_t block, int place, int query, CastMemory& memory);

  bool found() const { return triangle_ >= 0; }
  double range() const { return range_; }
  /// The answer; no hit if nothing was found.
  SegmentHit Hit(const BlockTree& tree) const;

 private:
  SegmentHit HitAt(const BlockTree& tree, size_t block, int place, double range) const;

  const SegmentQuery* query_ = nullptr;
  double rank_ = 0, range_ = 0;
  int object_ = 0;
  int triangle_ = -1;
  size_t block_ = 0;
  int place_ = 0;
};

}  // namespace eod::sim
