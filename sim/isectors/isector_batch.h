#pragma once

#include <span>
#include <vector>

#include "sim/isectors/isector.h"

namespace eod::sim {

/// Casts isectors together, and keeps the memory for it: one for each robot, thread or test.
class IsectorBatch {
 public:
  IsectorBatch() { memory_.surroundings.Reserve(); }

  /// Takes the memory for casts of so many segments now.
  void Reserve(size_t segments);

  /// Casts the enabled segments of all enabled `isectors` from their poses, in one call of
  /// `world`. Each isector is one group, so that its segments are culled together. Afterwards
  /// those isectors can be read for `step`, which is 0 or more. Allocates only where this cast is
  /// larger than those before.
  void CastIsectors(std::span<Isector> isectors, const World& world, int64_t step);

  /// What the last call cast, in the order of the isectors, and what it met.
  std::span<const SegmentQuery> queries() const { return queries_; }
  std::span<const SegmentHit> hits() const { return hits_; }
  /// Of hits()[i]: index of its isector and of its segment therein.
  int IsectorOf(size_t i) const { return sources_[i].isector; }
  int SegmentOf(size_t i) const { return sources_[i].segment; }
  /// Work of the last call.
  const CastCounters& counters() const { return memory_.counters; }

 private:
  struct Source {
    int isector;
    int segment;
  };
  void Collect(std::span<const Isector> isectors);
  void HandOut(std::span<Isector> isectors, int64_t step);

  std::vector<Source> sources_;  ///< one a query
  std::vector<SegmentQuery> queries_;
  std::vector<SegmentHit> hits_;
  CastMemory memory_;
};

}  // namespace eod::sim
