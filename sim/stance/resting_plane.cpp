#include "sim/stance/resting_plane.h"

#include <algorithm>
#include <cmath>

namespace eod::sim {
namespace {

using Eigen::Vector2d;

constexpr double kLeastArea = 1e-7;   // [m^2] twice that of the smallest triangle to rest on
constexpr double kInside = -1e-9;     // share of the load, for rounding on an edge
constexpr double kSticksOut = 1e-11;  // [m]
constexpr int kQuickPivots = 16;      // then by Bland's rule, which never runs in circles
constexpr int kMostPivots = 96;

double Cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

Vector2d Plan(const Prop& prop) { return {prop.x, prop.y}; }

/// The plane through three props.
void LayOn(std::span<const Prop> props, RestingPlane& plane) {
  const Prop& a = props[plane.props[0]];
  const Prop& b = props[plane.props[1]];
  const Prop& c = props[plane.props[2]];
  const Vector2d ab = Plan(b) - Plan(a), ac = Plan(c) - Plan(a);
  const double rise_b = b.height - a.height, rise_c = c.height - a.height;
  const double area = Cross(ab, ac);
  plane.slope =
      Vector2d(rise_b * ac.y() - rise_c * ab.y(), rise_c * ab.x() - rise_b * ac.x()) / area;
  plane.offset = a.height - plane.slope.dot(Plan(a));
}

/// The prop that sticks out most, or the first one that does; -1 if none does.
int Highest(std::span<const Prop> props, const RestingPlane& plane, bool first, double& by) {
  int highest = -1;
  by = kSticksOut;
  for (size_t i = 0; i < props.size(); ++i) {
    const double out = props[i].height - plane.At(props[i].x, props[i].y);
    if (out <= by) continue;
    by = out;
    highest = static_cast<int>(i);
    if (first) break;
  }
  return highest;
}

/// Puts `prop` in the place of that corner which leaves the centre deepest inside, or of the first
/// one that leaves it inside. False if there is no such corner.
bool Exchange(std::span<const Prop> props, const Vector2d& centre, int prop, bool first,
              RestingPlane& plane) {
  double best = 0;
  int place = -1;
  std::array<double, 3> best_load{};
  for (size_t corner = 0; corner < 3; ++corner) {
    std::array<int, 3> triangle = plane.props;
    triangle[corner] = prop;
    const std::array<double, 3> load = LoadOn(props, triangle, centre);
    const double least = *std::min_element(load.begin(), load.end());
    if (least < kInside) continue;
    if (place >= 0 &&
        (first ? plane.props[corner] > plane.props[static_cast<size_t>(place)] : least <= best))
      continue;
    best = least;
    place = static_cast<int>(corner);
    best_load = load;
  }
  if (place < 0) return false;
  plane.props[static_cast<size_t>(place)] = prop;
  plane.load = best_load;
  return true;
}

}  // namespace

std::array<double, 3> LoadOn(std::span<const Prop> props, const std::array<int, 3>& triangle,
                             const Vector2d& centre) {
  const Vector2d a = Plan(props[triangle[0]]) - centre;
  const Vector2d b = Plan(props[triangle[1]]) - centre;
  const Vector2d c = Plan(props[triangle[2]]) - centre;
  const double bc = Cross(b, c), ca = Cross(c, a), ab = Cross(a, b);
  const double area = bc + ca + ab;
  if (std::abs(area) < kLeastArea) return {-1, -1, -1};
  return {bc / area, ca / area, ab / area};
}

bool FindTriangle(std::span<const Prop> props, const Vector2d& centre,
                  std::array<int, 3>& triangle) {
  if (props.size() < 3) return false;
  int first = 0;
  for (size_t i = 1; i < props.size(); ++i) {
    const double away = (Plan(props[i]) - centre).squaredNorm();
    if (away > (Plan(props[first]) - centre).squaredNorm()) first = static_cast<int>(i);
  }
  // On either side of the line through the farthest one and the centre, the prop that turns
  // farthest from it; between them lies the way beyond the centre, or nothing does.
  const Vector2d from = Plan(props[first]) - centre;
  int left = -1, right = -1;
  for (size_t i = 0; i < props.size(); ++i) {
    const Vector2d to = Plan(props[i]) - centre;
    const double side = Cross(from, to);
    if (side > 0 && (left < 0 || Cross(Plan(props[left]) - centre, to) > 0)) {
      left = static_cast<int>(i);
    }
    if (side < 0 && (right < 0 || Cross(Plan(props[right]) - centre, to) < 0)) {
      right = static_cast<int>(i);
    }
  }
  if (left < 0 || right < 0) return false;
  triangle = {first, left, right};
  const std::array<double, 3> load = LoadOn(props, triangle, centre);
  return *std::min_element(load.begin(), load.end()) >= kInside;
}

RestingPlane RestOn(std::span<const Prop> props, const Vector2d& centre,
                    const std::array<int, 3>& start) {
  RestingPlane plane;
  plane.props = start;
  plane.load = LoadOn(props, start, centre);
  LayOn(props, plane);
  double out = 0;
  for (; plane.pivots < kMostPivots; ++plane.pivots) {
    const bool first = plane.pivots >= kQuickPivots;
    const int highest = Highest(props, plane, first, out);
    if (highest < 0) return plane;
    if (!Exchange(props, centre, highest, first, plane)) break;
    LayOn(props, plane);
  }
  // Rounding keeps the last one from a corner of its own: rest on it all the same.
  if (Highest(props, plane, false, out) >= 0) plane.offset += out;
  return plane;
}

}  // namespace eod::sim
