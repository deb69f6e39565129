#pragma once

#include "sim/segments/block_tree.h"
#include "sim/segments/cast_memory.h"

namespace eod::sim {

/// The triangle that answers a query, as far as triangles have been looked at. Does not depend on
/// the order in which they come: see IsPreferred.
class TriangleChoice {
 public:
  /// Nothing until `Begin`, so that many of them cost nothing.
  TriangleChoice() {}  // NOLINT
  explicit TriangleChoice(const SegmentQuery& query) { Begin(query); }
  void Begin(const SegmentQuery& query) {
    query_ = &query;
    triangle_ = -1;
  }

  /// Decides a candidate, of a class that the query looks for, exactly and keeps it if the query's
  /// rules prefer it.
  void Offer(const BlockTree& tree, size_t block, int place, int query, CastMemory& memory);

  bool found() const { return triangle_ >= 0; }
  double range() const { return range_; }
  /// The answer, if there is one.
  void Answer(const BlockTree& tree, SegmentHit& hit) const;

 private:
  void HitAt(const BlockTree& tree, size_t block, int place, double range, SegmentHit& hit) const;

  const SegmentQuery* query_;
  double rank_, range_;
  size_t block_;
  int place_;
  int object_;
  int triangle_;
};

}  // namespace eod::sim
