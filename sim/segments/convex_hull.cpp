#include "sim/segments/convex_hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace eod::sim {

using Eigen::Vector3d;

namespace {

constexpr double kThinnest = 1e-6;  // of the extent
// Points go onto a grid of this many steps, where whole numbers decide exactly on which side of a
// face a point lies: a determinant is below 2^123.
constexpr double kGridSteps = 0x1p40;
constexpr double kSamePlane = 1e-11;  // [-] and [m] far below what the answers promise

__extension__ using Wide = __int128;
using GridPoint = std::array<int64_t, 3>;

struct Face {
  std::array<size_t, 3> corner;  // counter-clockwise seen from outside
  std::array<Wide, 3> normal;
  bool visible;
};

/// Four points that span a volume, as far apart as is easily found.
std::array<size_t, 4> FirstFour(std::span<const Vector3d> points) {
  std::array<size_t, 4> found{};
  const auto farthest = [&](const auto& distance) {
    size_t best = 0;
    for (size_t i = 1; i < points.size(); ++i) {
      if (distance(points[i]) > distance(points[best])) best = i;
    }
    return best;
  };
  const Vector3d& a = points[0];
  found[1] = farthest([&](const Vector3d& p) { return (p - a).norm(); });
  const double extent = (points[found[1]] - a).norm();
  const Vector3d along = (points[found[1]] - a) / (extent > 0 ? extent : 1);
  const auto off_line = [&](const Vector3d& p) { return (p - a).cross(along).norm(); };
  found[2] = farthest(off_line);
  const Vector3d n = (points[found[2]] - a).cross(along).normalized();
  const auto off_plane = [&](const Vector3d& p) { return std::abs((p - a).dot(n)); };
  found[3] = farthest(off_plane);
  const double width = off_line(points[found[2]]), height = off_plane(points[found[3]]);
  if (!(std::min(width, height) > kThinnest * extent)) {
    throw std::runtime_error(
        fmt::format("convex hull: {} points of {} m extent have no volume", points.size(), extent));
  }
  return found;
}

class HullBuilder {
 public:
  explicit HullBuilder(std::span<const Vector3d> points) {
    Vector3d low = points[0], high = points[0];
    for (const Vector3d& point : points) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    const double steps_per_m = kGridSteps / (high - low).maxCoeff();
    for (const Vector3d& point : points) {
      const Vector3d steps = (point - low) * steps_per_m;
      grid_.push_back({std::llround(steps.x()), std::llround(steps.y()), std::llround(steps.z())});
    }
    const auto [a, b, c, d] = FirstFour(points);
    AddFace(a, b, c);
    const bool below = Side(faces_[0], d) < 0;
    faces_.clear();
    const size_t second = below ? b : c, third = below ? c : b;
    AddFace(a, second, third);
    AddFace(a, third, d);
    AddFace(third, second, d);
    AddFace(second, a, d);
    for (size_t i = 0; i < points.size(); ++i) Include(i);
  }

  const std::vector<Face>& faces() const { return faces_; }

 private:
  /// Positive outside of the face, 0 exactly in its plane.
  Wide Side(const Face& face, size_t point) const {
    Wide sum = 0;
    for (size_t axis = 0; axis < 3; ++axis) {
      sum += face.normal[axis] * (grid_[point][axis] - grid_[face.corner[0]][axis]);
    }
    return sum;
  }

  void AddFace(size_t a, size_t b, size_t c) {
    Face face{{a, b, c}, {}, false};
    for (size_t axis = 0; axis < 3; ++axis) {
      const size_t y = (axis + 1) % 3, z = (axis + 2) % 3;
      face.normal[axis] =
          static_cast<Wide>(grid_[b][y] - grid_[a][y]) * (grid_[c][z] - grid_[a][z]) -
          static_cast<Wide>(grid_[b][z] - grid_[a][z]) * (grid_[c][y] - grid_[a][y]);
    }
    faces_.push_back(face);
  }

  /// Replaces the faces that the point sees by a fan from the rim of what it sees.
  void Include(size_t point) {
    std::set<std::pair<size_t, size_t>> edges;
    for (Face& face : faces_) {
      face.visible = Side(face, point) > 0;
      if (!face.visible) continue;
      for (size_t i = 0; i < 3; ++i) edges.emplace(face.corner[i], face.corner[(i + 1) % 3]);
    }
    if (edges.empty()) return;
    std::erase_if(faces_, [](const Face& face) { return face.visible; });
    for (const auto& [from, to] : edges) {
      if (!edges.contains({to, from})) AddFace(from, to, point);
    }
  }

  std::vector<GridPoint> grid_;
  std::vector<Face> faces_;
};

/// The face's plane, moved out until it holds every point.
HullPlane PlaneOf(const Face& face, std::span<const Vector3d> points) {
  const Vector3d normal(static_cast<double>(face.normal[0]), static_cast<double>(face.normal[1]),
                        static_cast<double>(face.normal[2]));
  HullPlane plane{normal.normalized(), -std::numeric_limits<double>::infinity()};
  for (const Vector3d& point : points) {
    plane.offset = std::max(plane.offset, plane.normal.dot(point));
  }
  return plane;
}

}  // namespace

ConvexHull HullOf(std::span<const Vector3d> points) {
  for (const Vector3d& point : points) {
    if (!point.allFinite()) throw std::runtime_error("convex hull: a point is not finite");
  }
  if (points.size() < 4) {
    throw std::runtime_error(fmt::format("convex hull: {} points have no volume", points.size()));
  }
  ConvexHull hull;
  std::set<size_t> corners;
  const HullBuilder builder(points);
  for (const Face& face : builder.faces()) {
    corners.insert(face.corner.begin(), face.corner.end());
    const HullPlane plane = PlaneOf(face, points);
    const bool known = std::any_of(hull.planes.begin(), hull.planes.end(), [&](const auto& other) {
      return (other.normal - plane.normal).norm() < kSamePlane &&
             std::abs(other.offset - plane.offset) < kSamePlane;
    });
    if (!known) hull.planes.push_back(plane);
  }
  for (const size_t corner : corners) hull.corners.push_back(points[corner]);
  return hull;
}

}  // namespace eod::sim
