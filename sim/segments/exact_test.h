#pragma once

#include <optional>

#include "sim/segments/segment.h"

namespace eod::sim {

/// Range [m] at which `segment` meets the triangle a, b, c (counter-clockwise seen from its front),
/// within [0, length]; nothing if it passes by.
///
/// Exact: whether the line passes inside, outside or just along an edge is decided as if there were
/// no rounding, by a floating-point filter with exact arithmetic behind it. Edges and corners
/// belong to the triangle, so nothing slips through between neighbours. Edge-on triangles are not
/// met. The range is right to 1e-7 m, and near both ends to 1e-10 m. Source: Shewchuk, "Adaptive
/// Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997.
std::optional<double> Meet(const SegmentQuery& segment, const Eigen::Vector3d& a,
                           const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// d . ((b - s) x (c - s)): the side on which the line from s along d passes the edge b c. Its sign
/// is exact and its value right to a few units in the last place. Coordinates between 1e-60 and
/// 1e60, or 0.
double ExactSide(const Eigen::Vector3d& d, const Eigen::Vector3d& s, const Eigen::Vector3d& b,
                 const Eigen::Vector3d& c);

}  // namespace eod::sim
