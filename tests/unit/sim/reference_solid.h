#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace eod::sim {

/// Solids as signed distance functions in long double, and chords found by bisection: nothing in
/// common with the product's algebra.
using Real = long double;
using RealPoint = std::array<Real, 3>;
/// Convex in the point; negative inside, positive outside, 0 on the surface.
using DistanceFunction = std::function<Real(const RealPoint&)>;

inline DistanceFunction BoxDistance(const Eigen::Vector3d& size) {
  return [size](const RealPoint& p) {
    return std::max({std::abs(p[0]) - Real{size.x()} / 2, std::abs(p[1]) - Real{size.y()} / 2,
                     std::abs(p[2]) - Real{size.z()} / 2});
  };
}

inline DistanceFunction CylinderDistance(double radius, double length) {
  return [=](const RealPoint& p) {
    return std::max(std::hypot(p[0], p[1]) - Real{radius}, std::abs(p[2]) - Real{length} / 2);
  };
}

inline DistanceFunction CapsuleDistance(double radius, double length) {
  return [=](const RealPoint& p) {
    const Real beyond = std::max(Real{0}, std::abs(p[2]) - Real{length} / 2);
    return std::hypot(p[0], p[1], beyond) - Real{radius};
  };
}

/// Tries every three points for a face: all others must lie on one side.
inline DistanceFunction HullDistance(const std::vector<Eigen::Vector3d>& points) {
  struct Plane {
    RealPoint n;
    Real offset;
  };
  const auto real = [](const Eigen::Vector3d& p) { return RealPoint{p.x(), p.y(), p.z()}; };
  const auto dot = [](const RealPoint& a, const RealPoint& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  std::vector<Plane> planes;
  const auto try_plane = [&](const RealPoint& a, const RealPoint& b, const RealPoint& c) {
    const RealPoint u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const RealPoint v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    RealPoint n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const Real length = std::hypot(n[0], n[1], n[2]);
    if (length < 1e-12L) return;  // three in a row
    for (Real& one : n) one /= length;
    const Real offset = dot(n, a);
    for (const Eigen::Vector3d& point : points) {
      if (dot(n, real(point)) - offset > 1e-15L) return;
    }
    planes.push_back({n, offset});
  };
  for (size_t i = 0; i < points.size(); ++i) {
    for (size_t j = 0; j < points.size(); ++j) {
      for (size_t k = j + 1; k < points.size(); ++k) {  // i, j, k in both windings
        if (i != j && i != k) try_plane(real(points[i]), real(points[j]), real(points[k]));
      }
    }
  }
  return [planes, dot](const RealPoint& p) {
    Real most = -1e9L;
    for (const Plane& plane : planes) most = std::max(most, dot(plane.n, p) - plane.offset);
    return most;
  };
}

/// What a line has of a solid. Both ends of the chord, if it goes deeper than `depth` says.
struct ReferenceChord {
  Real depth = 0;  ///< of the line's deepest point, positive inside
  Real enter = 0, leave = 0;
};

/// The distance along a line is a convex function: its least value by thirds, then both zeros by
/// halves, all within [-reach, reach].
inline ReferenceChord ReferenceChordOf(const DistanceFunction& distance,
                                       const Eigen::Vector3d& start,
                                       const Eigen::Vector3d& direction, Real reach) {
  const auto at = [&](Real t) {
    return distance({start.x() + t * direction.x(), start.y() + t * direction.y(),
                     start.z() + t * direction.z()});
  };
  Real low = -reach, high = reach;
  for (int i = 0; i < 80; ++i) {
    const Real a = low + (high - low) / 3, b = high - (high - low) / 3;
    (at(a) < at(b) ? high : low) = at(a) < at(b) ? b : a;
  }
  const Real deepest = (low + high) / 2;
  ReferenceChord chord{.depth = -at(deepest)};
  if (chord.depth <= 0) return chord;
  const auto zero_between = [&](Real outside, Real inside) {
    for (int i = 0; i < 64; ++i) {
      const Real middle = (outside + inside) / 2;
      (at(middle) > 0 ? outside : inside) = middle;
    }
    return (outside + inside) / 2;
  };
  chord.enter = zero_between(-reach, deepest);
  chord.leave = zero_between(reach, deepest);
  return chord;
}

}  // namespace eod::sim
