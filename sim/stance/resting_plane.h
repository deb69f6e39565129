#pragma once

#include <array>
#include <span>

#include <Eigen/Core>

namespace eod::sim {

/// A point in plan view, and the height that nothing above it may go below.
struct Prop {
  double x = 0;
  double y = 0;
  double height = 0;
};

/// A plane z = offset + slope . (x, y) that lies on three props.
struct RestingPlane {
  double offset = 0;
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  std::array<int, 3> props{};    ///< indices of those that carry it
  std::array<double, 3> load{};  ///< share of the weight on each, 0..1, 1 together
  int pivots = 0;                ///< work

  double At(double x, double y) const { return offset + slope.x() * x + slope.y() * y; }
};

/// Three props with `centre` within their triangle in plan view. False if there are none: the
/// centre is outside the hull of all.
bool FindTriangle(std::span<const Prop> props, const Eigen::Vector2d& centre,
                  std::array<int, 3>& triangle);

/// Shares of a weight at `centre` on the corners of a triangle: negative where the centre is
/// outside that edge. Nothing (all -1) for a triangle without area.
std::array<double, 3> LoadOn(std::span<const Prop> props, const std::array<int, 3>& triangle,
                             const Eigen::Vector2d& centre);

/// How a rigid plane rests on props under a weight at `centre`: above all of them, and as low as
/// can be at the centre, which is the facet of their upper convex hull there. Simplex: from
/// `start`, a triangle around the centre, whatever sticks out of the plane replaces one of its
/// corners. Same inputs, same bits; always ends; allocates nothing.
RestingPlane RestOn(std::span<const Prop> props, const Eigen::Vector2d& centre,
                    const std::array<int, 3>& start);

}  // namespace eod::sim
