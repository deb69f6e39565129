#pragma once

#include "sim/segments/kernels.h"
#include "sim/segments/triangle_choice.h"

namespace eod::sim {

/// Walks the tree along one segment, nearest boxes first, and stops at the hit that answers.
void WalkAlong(const BlockTree& tree, const Kernels& kernels, const SegmentQuery& segment,
               int query, TriangleChoice& choice, CastMemory& memory);

}  // namespace eod::sim
