#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <span>

#include "sim/segments/block_tree.h"

namespace eod::sim {

/// A triangle's box while the tree is built [m]. Fourth places: padding, and the triangle's index
/// bit for bit.
struct alignas(16) Item {
  float low[4];
  float high[4];
  size_t index() const { return std::bit_cast<uint32_t>(high[3]); }
};

/// A growing box; starts empty. Fourth places are padding.
struct alignas(16) Box4 {
  float low[4] = {kFar, kFar, kFar, kFar};
  float high[4] = {-kFar, -kFar, -kFar, -kFar};
  static constexpr float kFar = std::numeric_limits<float>::infinity();
};

/// Half the surface of the box [m^2]; 0 while empty.
double HalfArea(const Box4& box);

inline float CentreOf(const Item& item, int axis) { return item.low[axis] + item.high[axis]; }

/// Widens `box` by the item's box and `centres` by its centre (twice its coordinates).
void Grow(const Item& item, Box4& box, Box4& centres);

/// Widens `box` by another one.
void Include(const Box4& other, Box4& box);

/// Axis along which the centres differ most.
int WidestAxis(const Box4& centres);

/// Left of the cut is what lies in a bin below `bin`.
struct Cut {
  int axis = -1;  ///< -1: no cut parts these items
  int bin = 0;
  float low = 0, scale = 0;
  bool IsLeft(const Item& item) const;
};

/// The cut of least cost by the surface-area heuristic, in bins; blocks are the unit of cost.
Cut BestCut(std::span<const Item> items, const Box4& centres);

/// A node whose eight boxes are points at infinity.
Node EmptyNode();
uint32_t ClassesBelow(const Node& node);

}  // namespace eod::sim
