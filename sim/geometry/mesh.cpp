#include "sim/geometry/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace eod::sim {

namespace {

using Eigen::Vector3d;

/// Two triangles for the corners a, b, c, d of a flat quadrilateral, counter-clockwise.
void AddQuad(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d,
             Mesh& mesh) {
  mesh.push_back({a, b, c});
  mesh.push_back({a, c, d});
}

Vector3d OnCircle(double radius, int corner, int sides, double z) {
  const double angle = 2 * std::numbers::pi * (corner % sides) / sides;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// A regular polygon in strips from side to side, counter-clockwise. In a fan, all triangles would
/// meet in the middle, and what lies there would touch every one of them.
std::vector<std::array<int, 3>> StripsOf(int sides) {
  std::vector<std::array<int, 3>> triangles;
  int right = 0, left = sides - 1;
  while (left - right > 1) {
    triangles.push_back({right, right + 1, left});
    ++right;
    if (left - right > 1) {
      triangles.push_back({right, left - 1, left});
      --left;
    }
  }
  return triangles;
}

}  // namespace

Mesh BoxMesh(const Vector3d& size) {
  const Vector3d h = size / 2;
  const auto corner = [&h](int x, int y, int z) {
    return Vector3d(x * h.x(), y * h.y(), z * h.z());
  };
  Mesh mesh;
  AddQuad(corner(1, -1, -1), corner(1, 1, -1), corner(1, 1, 1), corner(1, -1, 1), mesh);
  AddQuad(corner(-1, 1, -1), corner(-1, -1, -1), corner(-1, -1, 1), corner(-1, 1, 1), mesh);
  AddQuad(corner(1, 1, -1), corner(-1, 1, -1), corner(-1, 1, 1), corner(1, 1, 1), mesh);
  AddQuad(corner(-1, -1, -1), corner(1, -1, -1), corner(1, -1, 1), corner(-1, -1, 1), mesh);
  AddQuad(corner(-1, -1, 1), corner(1, -1, 1), corner(1, 1, 1), corner(-1, 1, 1), mesh);
  AddQuad(corner(-1, 1, -1), corner(1, 1, -1), corner(1, -1, -1), corner(-1, -1, -1), mesh);
  return mesh;
}

Mesh CylinderMesh(double radius, double length, int sides) {
  const double top = length / 2, bottom = -top;
  Mesh mesh;
  for (int i = 0; i < sides; ++i) {
    const Vector3d a = OnCircle(radius, i, sides, bottom),
                   b = OnCircle(radius, i + 1, sides, bottom);
    const Vector3d c = OnCircle(radius, i + 1, sides, top), d = OnCircle(radius, i, sides, top);
    AddQuad(a, b, c, d, mesh);
  }
  for (const std::array<int, 3>& corners : StripsOf(sides)) {
    const auto at = [&](int corner, double z) { return OnCircle(radius, corner, sides, z); };
    const auto [a, b, c] = corners;
    mesh.push_back({at(a, top), at(b, top), at(c, top)});
    mesh.push_back({at(a, bottom), at(c, bottom), at(b, bottom)});
  }
  return mesh;
}

Mesh ConeMesh(double radius, double length, int sides) {
  const Vector3d tip(0, 0, length / 2), centre(0, 0, -length / 2);
  Mesh mesh;
  for (int i = 0; i < sides; ++i) {
    const Vector3d a = OnCircle(radius, i, sides, centre.z());
    const Vector3d b = OnCircle(radius, i + 1, sides, centre.z());
    mesh.push_back({a, b, tip});
    mesh.push_back({centre, b, a});
  }
  return mesh;
}

Mesh SphereMesh(double radius, int rings, int sides) {
  // Poles exactly on the axis, so that the bands there are triangles.
  const auto point = [=](int ring, int side) -> Vector3d {
    if (ring == 0) return {0, 0, -radius};
    if (ring == rings) return {0, 0, radius};
    const double latitude = std::numbers::pi * (static_cast<double>(ring) / rings - 0.5);
    return OnCircle(radius * std::cos(latitude), side, sides, radius * std::sin(latitude));
  };
  Mesh mesh;
  for (int ring = 0; ring < rings; ++ring) {
    for (int side = 0; side < sides; ++side) {
      const Vector3d a = point(ring, side), b = point(ring, side + 1);
      const Vector3d c = point(ring + 1, side + 1), d = point(ring + 1, side);
      if (ring > 0) mesh.push_back({a, b, c});
      if (ring + 1 < rings) mesh.push_back({a, c, d});
      if (ring + 1 == rings) mesh.back() = {a, b, c};
      if (ring == 0) mesh.back() = {a, c, d};
    }
  }
  return mesh;
}

Mesh CapsuleMesh(double radius, double length, int rings, int sides) {
  // An even number of bands has a ring at the equator: there each half is pulled out.
  Mesh mesh = SphereMesh(radius, rings + rings % 2, sides);
  const auto lift = [half = length / 2](double centre_z, Vector3d& corner) {
    corner.z() += centre_z > 0 ? half : -half;
  };
  for (Triangle& triangle : mesh) {
    const double centre_z = triangle[0].z() + triangle[1].z() + triangle[2].z();
    for (Vector3d& corner : triangle) lift(centre_z, corner);
  }
  for (int i = 0; i < sides; ++i) {
    AddQuad(OnCircle(radius, i, sides, -length / 2), OnCircle(radius, i + 1, sides, -length / 2),
            OnCircle(radius, i + 1, sides, length / 2), OnCircle(radius, i, sides, length / 2),
            mesh);
  }
  return mesh;
}

Mesh PlaneMesh(double size_x, double size_y, double cell) {
  const int columns = std::max(1, static_cast<int>(std::ceil(size_x / cell - 1e-9)));
  const int rows = std::max(1, static_cast<int>(std::ceil(size_y / cell - 1e-9)));
  const auto point = [=](int column, int row) {
    return Vector3d(size_x * (static_cast<double>(column) / columns - 0.5),
                    size_y * (static_cast<double>(row) / rows - 0.5), 0);
  };
  Mesh mesh;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      AddQuad(point(column, row), point(column + 1, row), point(column + 1, row + 1),
              point(column, row + 1), mesh);
    }
  }
  return mesh;
}

Mesh Transformed(const Eigen::Isometry3d& X_AB, Mesh mesh) {
  for (Triangle& triangle : mesh) {
    for (Vector3d& corner : triangle) corner = X_AB * corner;
  }
  return mesh;
}

}  // namespace eod::sim
