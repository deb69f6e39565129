#pragma once

#include <vector>

#include "sim/segments/block_tree.h"
#include "tests/unit/sim/random_scene.h"

namespace eod::sim {

/// Some dozens of triangles that a tree and its arithmetic can stumble over, other ones for every
/// seed: loose ones, closed bodies, ground in relief, splinters, huge ones among small ones, and
/// bodies on a grid whose coplanar faces and shared edges are exact; near the origin and 1.5 km
/// from it.
std::vector<CollisionTriangle> TrickyScene(uint64_t seed);

/// Segments for such a scene: at random, through corners and edges, along edges, within planes,
/// from and to faces, of no length, long, from inside bodies, and one in fifty that is none at all
/// (NaN, infinite, of negative length or no unit direction). One group for some neighbours.
std::vector<SegmentQuery> TrickySegments(const std::vector<CollisionTriangle>& scene, size_t count,
                                         uint64_t seed);

}  // namespace eod::sim
