#include "sim/segments/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/segments/segment.h"

namespace eod::sim {

using Eigen::Vector3d;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Steeper than this against a face is parallel to it: over 100 m a tenth of a nanometre.
constexpr double kParallel = 1e-12;

struct Line {
  Vector3d start, direction;
  Vector3d At(double range) const { return start + range * direction; }
};

struct Interval {
  double enter = -kInfinity, leave = kInfinity;
  bool empty() const { return enter > leave; }
};

constexpr Interval kNothing{kInfinity, -kInfinity};

/// Where a line is within `radius` of a point (or an axis), from what of start and direction lies
/// across it: a = |d|^2, b = s.d, `cross` = |s x d|, `away` = |s|. Passing by at up to `slack`
/// counts as touching.
Interval WithinRadius(double a, double b, double cross, double away, double radius, double slack) {
  if (a < kParallel * kParallel) return away <= radius + slack ? Interval{} : kNothing;
  const double length = std::sqrt(a);
  if (cross > (radius + slack) * length) return kNothing;
  const double square = (radius * length - cross) * (radius * length + cross);
  if (square <= 0) return {-b / a, -b / a};
  // Of the two roots the one without cancellation, and the other by their product.
  const double root = std::sqrt(square);
  const double q = b > 0 ? -(b + root) : root - b;
  const double one = q / a, other = (away - radius) * (away + radius) / q;
  return {std::min(one, other), std::max(one, other)};
}

Interval WithinBall(const Line& line, const Vector3d& centre, double radius, double slack) {
  const Vector3d s = line.start - centre;
  const Vector3d& d = line.direction;
  return WithinRadius(d.squaredNorm(), s.dot(d), s.cross(d).norm(), s.norm(), radius, slack);
}

/// Round the Z axis.
Interval WithinPipe(const Line& line, double radius, double slack) {
  const Vector3d& s = line.start;
  const Vector3d& d = line.direction;
  return WithinRadius(d.x() * d.x() + d.y() * d.y(), s.x() * d.x() + s.y() * d.y(),
                      std::abs(s.x() * d.y() - s.y() * d.x()), std::hypot(s.x(), s.y()), radius,
                      slack);
}

/// Cuts the chord by the half-space below a face; false if the line runs outside along it.
bool CutByFace(const Vector3d& normal, double offset, const Line& line, Chord& chord) {
  const double height = normal.dot(line.start) - offset, slope = normal.dot(line.direction);
  if (std::abs(slope) < kParallel) return height <= kEndTolerance;
  const double range = -height / slope;
  if (slope < 0 && range > chord.enter) {
    chord.enter = range;
    chord.n_enter = normal;
  } else if (slope > 0 && range < chord.leave) {
    chord.leave = range;
    chord.n_leave = normal;
  }
  return true;
}

/// Both faces across `axis`, `half` from the origin.
bool CutBySlab(int axis, double half, const Line& line, Chord& chord) {
  const Vector3d n = Vector3d::Unit(axis);
  return CutByFace(n, half, line, chord) && CutByFace(-n, half, line, chord);
}

const Chord kWholeLine{.enter = -kInfinity, .leave = kInfinity};

std::optional<Chord> Cut(const BoxSolid& box, const Line& line) {
  Chord chord = kWholeLine;
  for (int axis = 0; axis < 3; ++axis) {
    if (!CutBySlab(axis, box.half[axis], line, chord)) return std::nullopt;
  }
  return chord;
}

std::optional<Chord> Cut(const CylinderSolid& cylinder, const Line& line) {
  Chord chord = kWholeLine;
  const Interval side = WithinPipe(line, cylinder.radius, kEndTolerance);
  if (side.empty() || !CutBySlab(2, cylinder.half_length, line, chord)) return std::nullopt;
  const auto outward = [&line](double range) {
    const Vector3d point = line.At(range);
    return Vector3d(point.x(), point.y(), 0).normalized();
  };
  if (side.enter > chord.enter) {
    chord.enter = side.enter;
    chord.n_enter = outward(side.enter);
  }
  if (side.leave < chord.leave) {
    chord.leave = side.leave;
    chord.n_leave = outward(side.leave);
  }
  return chord;
}

std::optional<Chord> Cut(const SphereSolid& sphere, const Line& line) {
  const Interval inside = WithinBall(line, Vector3d::Zero(), sphere.radius, kEndTolerance);
  if (inside.empty()) return std::nullopt;
  return Chord{inside.enter, inside.leave, line.At(inside.enter).normalized(),
               line.At(inside.leave).normalized()};
}

/// A pipe and two balls overlap, so that a line has one interval in them together.
Interval WithinCapsule(const CapsuleSolid& capsule, const Line& line, double slack) {
  const Vector3d end(0, 0, capsule.half_length);
  Interval pipe = WithinPipe(line, capsule.radius, slack);
  Chord straight{pipe.enter, pipe.leave};
  if (!CutBySlab(2, capsule.half_length, line, straight)) pipe = kNothing;
  if (!pipe.empty()) pipe = {straight.enter, straight.leave};
  Interval all = kNothing;
  for (const Interval& part : {pipe, WithinBall(line, end, capsule.radius, slack),
                               WithinBall(line, -end, capsule.radius, slack)}) {
    if (part.empty()) continue;
    all = {std::min(all.enter, part.enter), std::max(all.leave, part.leave)};
  }
  return all;
}

SurfaceNear Near(const CapsuleSolid& capsule, const Vector3d& point) {
  const double z = std::clamp(point.z(), -capsule.half_length, capsule.half_length);
  const Vector3d from_axis = point - Vector3d(0, 0, z);
  const double away = from_axis.norm();
  return {away - capsule.radius, away > 0 ? Vector3d(from_axis / away) : Vector3d::UnitX()};
}

std::optional<Chord> Cut(const CapsuleSolid& capsule, const Line& line) {
  // A mere touch of one part must not count where another part is met properly.
  Interval inside = WithinCapsule(capsule, line, 0);
  if (inside.empty()) inside = WithinCapsule(capsule, line, kEndTolerance);
  if (inside.empty()) return std::nullopt;
  return Chord{inside.enter, inside.leave, Near(capsule, line.At(inside.enter)).normal,
               Near(capsule, line.At(inside.leave)).normal};
}

std::optional<Chord> Cut(const HullSolid& hull, const Line& line) {
  Chord chord = kWholeLine;
  for (const HullPlane& plane : hull.planes) {
    if (!CutByFace(plane.normal, plane.offset, line, chord)) return std::nullopt;
  }
  return chord;
}

SurfaceNear Near(const BoxSolid& box, const Vector3d& point) {
  int axis = 0;
  const double distance = (point.cwiseAbs() - box.half).maxCoeff(&axis);
  return {distance, std::copysign(1.0, point[axis]) * Vector3d::Unit(axis)};
}

SurfaceNear Near(const CylinderSolid& cylinder, const Vector3d& point) {
  const double across = std::hypot(point.x(), point.y());
  const SurfaceNear cap{std::abs(point.z()) - cylinder.half_length,
                        std::copysign(1.0, point.z()) * Vector3d::UnitZ()};
  if (across == 0 || cap.distance >= across - cylinder.radius) return cap;
  return {across - cylinder.radius, Vector3d(point.x(), point.y(), 0) / across};
}

SurfaceNear Near(const SphereSolid& sphere, const Vector3d& point) {
  return Near(CapsuleSolid{sphere.radius, 0}, point);
}

SurfaceNear Near(const HullSolid& hull, const Vector3d& point) {
  SurfaceNear nearest{-kInfinity};
  for (const HullPlane& plane : hull.planes) {
    const double height = plane.normal.dot(point) - plane.offset;
    if (height > nearest.distance) nearest = {height, plane.normal};
  }
  return nearest;
}

/// Half the extents in M of a solid whose axis is Z.
Vector3d HalfExtents(const BoxSolid& box, const Eigen::Matrix3d& R_MS) {
  return R_MS.cwiseAbs() * box.half;
}
Vector3d HalfExtents(const CylinderSolid& cylinder, const Eigen::Matrix3d& R_MS) {
  const Eigen::Array3d along = R_MS.col(2).array().abs();
  const Eigen::Array3d across = (1 - along.square()).max(0).sqrt();
  return cylinder.half_length * along + cylinder.radius * across;
}
Vector3d HalfExtents(const SphereSolid& sphere, const Eigen::Matrix3d&) {
  return Vector3d::Constant(sphere.radius);
}
Vector3d HalfExtents(const CapsuleSolid& capsule, const Eigen::Matrix3d& R_MS) {
  return capsule.half_length * R_MS.col(2).array().abs() + capsule.radius;
}

template <typename AnySolid>
Eigen::AlignedBox3d Bounds(const AnySolid& solid, const Eigen::Isometry3d& X_MS) {
  const Vector3d half = HalfExtents(solid, X_MS.linear());
  return {X_MS.translation() - half, X_MS.translation() + half};
}
Eigen::AlignedBox3d Bounds(const HullSolid& hull, const Eigen::Isometry3d& X_MS) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& corner : hull.corners) box.extend(X_MS * corner);
  return box;
}

}  // namespace

std::optional<Chord> ChordOf(const Solid& solid, const Vector3d& start, const Vector3d& direction) {
  const Line line{start, direction};
  std::optional<Chord> chord = std::visit([&](const auto& one) { return Cut(one, line); }, solid);
  if (!chord || chord->enter <= chord->leave) return chord;
  // It passes outside of an edge: near enough to touch it?
  const double middle = (chord->enter + chord->leave) / 2;
  if (!(NearestSurface(solid, line.At(middle)).distance <= kEndTolerance)) return std::nullopt;
  chord->enter = chord->leave = middle;
  return chord;
}

SurfaceNear NearestSurface(const Solid& solid, const Vector3d& point) {
  return std::visit([&](const auto& one) { return Near(one, point); }, solid);
}

Eigen::AlignedBox3d BoundsOf(const Solid& solid, const Eigen::Isometry3d& X_MS) {
  return std::visit([&](const auto& one) { return Bounds(one, X_MS); }, solid);
}

}  // namespace eod::sim
