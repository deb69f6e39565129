#pragma once

#include "sim/segments/block_tree.h"
#include "sim/segments/cast_memory.h"
#include "sim/segments/hit_choice.h"

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
    order_.triangle = -1;
  }

  /// Decides a candidate, of a class that the query looks for, exactly and keeps it if the query's
  /// rules prefer it.
  void Offer(const BlockTree& tree, size_t block, int place, int query, CastMemory& memory);

  bool found() const { return order_.triangle >= 0; }
  double range() const { return range_; }
  /// The answer, if there is one.
  void Answer(const BlockTree& tree, SegmentHit& hit) const;

 private:
  void HitAt(const BlockTree& tree, size_t block, int place, double range, SegmentHit& hit) const;

  const SegmentQuery* query_;
  HitOrder order_;  ///< triangle -1: none
  double range_;
  size_t block_;
  int place_;
};

}  // namespace eod::sim
