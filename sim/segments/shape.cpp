#include "sim/segments/shape.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/segments/hit_choice.h"

namespace eod::sim {

using Eigen::Vector3d;

namespace {

constexpr double kSmallest = 1e-6;  // [m] far above the tolerance of touches

double Checked(const char* name, double size) {
  if (std::isfinite(size) && size >= kSmallest) return size;
  throw std::runtime_error(
      fmt::format("{} = {} m, needs a finite length of {} m or more", name, size, kSmallest));
}

}  // namespace

Shape Shape::Box(const Vector3d& size) {
  for (int axis = 0; axis < 3; ++axis) Checked("size of a box", size[axis]);
  return Shape(BoxSolid{size / 2});
}

Shape Shape::Cylinder(double radius, double length) {
  return Shape(CylinderSolid{Checked("radius of a cylinder", radius),
                             Checked("length of a cylinder", length) / 2});
}

Shape Shape::Sphere(double radius) {
  return Shape(SphereSolid{Checked("radius of a sphere", radius)});
}

Shape Shape::Capsule(double radius, double length) {
  return Shape(CapsuleSolid{Checked("radius of a capsule", radius),
                            Checked("length of a capsule", length) / 2});
}

Shape Shape::Of(const Primitive& primitive) {
  const Vector3d& size = primitive.size;
  switch (primitive.kind) {
    case Primitive::Kind::kCylinder:
      return Cylinder(size.x(), size.z());
    case Primitive::Kind::kSphere:
      return Sphere(size.x());
    case Primitive::Kind::kCapsule:
      return Capsule(size.x(), size.z());
    default:
      return Box(size);
  }
}

Shape Shape::Hull(std::span<const Vector3d> points) { return Shape(HullOf(points)); }

Crossings Shape::Cross(const Vector3d& start, const Vector3d& direction, double length) const {
  Crossings crossings;
  const auto add = [&](double range, const Vector3d& normal, bool entry) {
    const auto on_segment = OnSegment(range, length);
    if (on_segment) crossings.list[crossings.count++] = {*on_segment, normal, entry};
  };
  if (length <= kEndTolerance) {
    const SurfaceNear near = NearestSurface(solid_, start);
    if (std::abs(near.distance) > kEndTolerance) return crossings;
    add(0, near.normal, near.normal.dot(direction) < 0);
    return crossings;
  }
  const std::optional<Chord> chord = ChordOf(solid_, start, direction);
  if (!chord) return crossings;
  const bool touch = chord->leave - chord->enter <= kEndTolerance;
  add(chord->enter, chord->n_enter, !touch);
  if (!touch) add(chord->leave, chord->n_leave, false);
  return crossings;
}

}  // namespace eod::sim
