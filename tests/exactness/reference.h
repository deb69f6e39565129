#pragma once

#include <span>
#include <vector>

#include "sim/segments/block_tree.h"
#include "sim/segments/segment.h"

namespace eod::sim {

/// A triangle that a segment meets, by the reference.
struct ReferenceHit {
  size_t triangle = 0;  ///< index in the list
  long double range = 0;
  bool doubtful = false;  ///< within 1e-12 m of where the segment ends: both answers are right
};

/// Every triangle against the segment, without any tree: in extended precision, and in rational
/// numbers (GMP) wherever that does not settle a sign. Shares no code with the engine.
/// `hits` comes back sorted by range.
void MeetAll(std::span<const CollisionTriangle> triangles, const SegmentQuery& segment,
             std::vector<ReferenceHit>& hits);

}  // namespace eod::sim
