#include "sim/camera/surface_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <span>

#include "sim/camera/noise.h"

namespace eod::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

uint8_t ToByte(double value) {
  return static_cast<uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255.0));
}

/// Writes vertices of one visual: applies its pose and material.
class VisualWriter {
 public:
  VisualWriter(const Visual& visual, const Eigen::Isometry3d& X_BO, int bone, SurfaceMesh& mesh)
      : material_(visual.material), X_BV_(X_BO * visual.X_OV), bone_(bone), mesh_(mesh) {}

  /// `metres`: texture coordinate on the surface [m].
  uint32_t Add(const Vector3d& position, const Vector3d& normal, const Vector2d& metres) {
    const Vector3d p_B = X_BV_ * position;
    const Vector3d n_B = (X_BV_.linear() * normal).normalized();
    const double tile = std::max(static_cast<double>(material_.texture_scale_m), 1e-3);
    Vertex vertex{};
    for (int axis = 0; axis < 3; ++axis) {
      vertex.position[axis] = static_cast<float>(p_B[axis]);
      vertex.normal[axis] = static_cast<int16_t>(std::lround(n_B[axis] * 32767.0));
      vertex.diffuse[axis] =
          ToByte(std::sqrt(std::max(static_cast<double>(material_.diffuse[axis]), 0.0)));
      // Colour times light: a dark thing needs more of it to shine.
      vertex.lamps[axis] = ToByte(std::sqrt(static_cast<double>(
          material_.emissive[axis] / (kBrightest * std::max(material_.diffuse[axis], 0.05F)))));
    }
    vertex.sky = 255;
    vertex.bone = static_cast<uint16_t>(bone_);
    vertex.uv[0] = static_cast<float>(metres.x() / tile);
    vertex.uv[1] = static_cast<float>(metres.y() / tile);
    vertex.specular = ToByte(static_cast<double>(material_.specular));
    mesh_.vertices.push_back(vertex);
    return static_cast<uint32_t>(mesh_.vertices.size() - 1);
  }

  void Triangle(uint32_t a, uint32_t b, uint32_t c) {
    mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
  }

  /// Flat convex polygon around `normal`; corners in either order of turning.
  void Polygon(std::span<const Vector3d> corners, const Vector3d& normal, const Vector3d& origin) {
    const Vector3d turn = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const bool outwards = turn.dot(normal) > 0;
    std::array<uint32_t, 4> index{};
    for (size_t i = 0; i < corners.size(); ++i) {
      const Vector3d& corner = corners[outwards ? i : corners.size() - 1 - i];
      index[i] = Add(corner, normal, PlanarMetres(corner - origin, normal));
    }
    for (size_t i = 2; i < corners.size(); ++i) Triangle(index[0], index[i - 1], index[i]);
  }

 private:
  /// Texture plane square to the axis that the normal is nearest to; v points up on walls.
  static Vector2d PlanarMetres(const Vector3d& point, const Vector3d& normal) {
    const Vector3d size = normal.cwiseAbs();
    if (size.z() >= size.x() && size.z() >= size.y()) return {point.x(), point.y()};
    if (size.x() >= size.y()) return {point.y(), point.z()};
    return {point.x(), point.z()};
  }

  const Material& material_;
  Eigen::Isometry3d X_BV_;
  int bone_;
  SurfaceMesh& mesh_;
};

/// Corner of a chamfered box that lies on the face square to `axis`.
Vector3d FaceCorner(const Vector3d& half, double chamfer, const Vector3d& sign, int axis) {
  Vector3d corner = sign.cwiseProduct(half - Vector3d::Constant(chamfer));
  corner[axis] = sign[axis] * half[axis];
  return corner;
}

void WriteBox(const Vector3d& size, double wanted_chamfer, VisualWriter& writer) {
  const Vector3d half = size / 2;
  const double chamfer = half.minCoeff() >= 3 * wanted_chamfer ? wanted_chamfer : 0.0;
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3;
    const int c = (a + 2) % 3;
    for (const double sa : {-1.0, 1.0}) {
      const auto sign = [&](double sb, double sc) {
        Vector3d s;
        s[a] = sa;
        s[b] = sb;
        s[c] = sc;
        return s;
      };
      const std::array face{
          FaceCorner(half, chamfer, sign(-1, -1), a), FaceCorner(half, chamfer, sign(1, -1), a),
          FaceCorner(half, chamfer, sign(1, 1), a), FaceCorner(half, chamfer, sign(-1, 1), a)};
      writer.Polygon(face, Vector3d(sa * Vector3d::Unit(a)), -half);
      if (chamfer == 0.0) continue;
      for (const double sb : {-1.0, 1.0}) {
        const std::array edge{
            FaceCorner(half, chamfer, sign(sb, -1), a), FaceCorner(half, chamfer, sign(sb, 1), a),
            FaceCorner(half, chamfer, sign(sb, 1), b), FaceCorner(half, chamfer, sign(sb, -1), b)};
        writer.Polygon(edge, (sa * Vector3d::Unit(a) + sb * Vector3d::Unit(b)).normalized(), -half);
      }
    }
  }
  if (chamfer == 0.0) return;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                        (corner & 4) != 0 ? 1 : -1);
    const std::array tip{FaceCorner(half, chamfer, sign, 0), FaceCorner(half, chamfer, sign, 1),
                         FaceCorner(half, chamfer, sign, 2)};
    writer.Polygon(tip, sign.normalized(), -half);
  }
}

int RoundSegments(double radius, const Detail& detail) {
  return std::min(std::clamp(static_cast<int>(10 + radius * 50), 10, 24), detail.max_segments);
}

/// Cylinder or cone about Z: `top_radius` 0 for a cone. v runs around, so that lugs of a tyre and
/// the grain of a post lie as they should.
void WriteRound(const Vector3d& size, double top_radius, const Detail& detail,
                VisualWriter& writer) {
  const double radius = size.x();
  const double length = size.z();
  const int segments = RoundSegments(radius, detail);
  const double half = length / 2;
  const double slope = (radius - top_radius) / length;
  std::array<uint32_t, 2> previous{};
  for (int i = 0; i <= segments; ++i) {
    const double angle = 2 * kPi * i / segments;
    const Vector3d out(std::cos(angle), std::sin(angle), 0);
    const Vector3d normal = (out + slope * Vector3d::UnitZ()).normalized();
    const std::array<uint32_t, 2> ring{
        writer.Add(out * radius - half * Vector3d::UnitZ(), normal, {0, angle * radius}),
        writer.Add(out * top_radius + half * Vector3d::UnitZ(), normal, {length, angle * radius})};
    if (i > 0) {
      writer.Triangle(previous[0], ring[0], ring[1]);
      if (top_radius > 0) writer.Triangle(previous[0], ring[1], previous[1]);
    }
    previous = ring;
  }
  for (const double end : {-1.0, 1.0}) {
    const double end_radius = end < 0 ? radius : top_radius;
    if (end_radius <= 0) continue;
    const Vector3d normal = end * Vector3d::UnitZ();
    const uint32_t centre = writer.Add(half * normal, normal, {0, 0});
    uint32_t last = 0;
    for (int i = 0; i <= segments; ++i) {
      const double angle = 2 * kPi * i / segments;
      const Vector2d rim = end_radius * Vector2d(std::cos(angle), std::sin(angle));
      const uint32_t next = writer.Add({rim.x(), rim.y(), end * half}, normal, rim);
      if (i > 0 && end > 0) writer.Triangle(centre, last, next);
      if (i > 0 && end < 0) writer.Triangle(centre, next, last);
      last = next;
    }
  }
}

/// Radius in a direction: crowns of trees are no billiard balls.
double LumpyRadius(double radius, const Vector3d& out) {
  const Eigen::Vector3f place = (out * 2.1 + Vector3d::Constant(8)).cast<float>();
  const float lumps =
      TilingNoise(place.x() + 0.7F * place.z(), place.y() - 0.6F * place.z(), 64, 5);
  return radius * (0.86 + 0.28 * static_cast<double>(lumps));
}

void WriteSphere(double radius, bool is_foliage, const Detail& detail, VisualWriter& writer) {
  const int segments = std::min(RoundSegments(radius, detail), 20);
  const int rings = segments / 2;
  std::vector<uint32_t> below;
  for (int ring = 0; ring <= rings; ++ring) {
    const double latitude = kPi * ring / rings - kPi / 2;
    std::vector<uint32_t> row;
    for (int i = 0; i <= segments; ++i) {
      const double angle = 2 * kPi * i / segments;
      const Vector3d out(std::cos(latitude) * std::cos(angle), std::cos(latitude) * std::sin(angle),
                         std::sin(latitude));
      const double reach = is_foliage ? LumpyRadius(radius, out) : radius;
      row.push_back(writer.Add(out * reach, out, Vector2d(angle, latitude) * radius));
    }
    for (size_t i = 1; ring > 0 && i < row.size(); ++i) {
      writer.Triangle(below[i - 1], below[i], row[i]);
      writer.Triangle(below[i - 1], row[i], row[i - 1]);
    }
    below = std::move(row);
  }
}

void WriteTriangles(std::span<const Eigen::Vector3f> corners, VisualWriter& writer) {
  for (size_t i = 0; i + 2 < corners.size(); i += 3) {
    const std::array triangle{Vector3d(corners[i].cast<double>()),
                              Vector3d(corners[i + 1].cast<double>()),
                              Vector3d(corners[i + 2].cast<double>())};
    const Vector3d normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    if (normal.squaredNorm() == 0) continue;
    writer.Polygon(triangle, normal.normalized(), Vector3d::Zero());
  }
}

/// The triangles with all corners within one cube of the grid moved to the first of them. Those
/// that collapse, or fall onto another one, are left out.
std::vector<Eigen::Vector3f> Clustered(std::span<const Eigen::Vector3f> corners, double side) {
  std::map<std::array<int, 3>, Eigen::Vector3f> firsts;
  std::map<std::array<int, 3>, int> numbers;  // of the cubes
  std::set<std::array<int, 3>> seen;          // triangles, by the numbers of their cubes
  std::vector<Eigen::Vector3f> result;
  for (size_t i = 0; i + 2 < corners.size(); i += 3) {
    std::array<Eigen::Vector3f, 3> triangle;
    std::array<int, 3> cubes{};
    for (size_t corner = 0; corner < 3; ++corner) {
      const Eigen::Vector3f& p = corners[i + corner];
      const Eigen::Array3i cube = (p.array() / static_cast<float>(side)).floor().cast<int>();
      const std::array<int, 3> key{cube.x(), cube.y(), cube.z()};
      triangle[corner] = firsts.try_emplace(key, p).first->second;
      cubes[corner] = numbers.try_emplace(key, static_cast<int>(numbers.size())).first->second;
    }
    // Turned so that its smallest number comes first: a triangle seen from behind is another one.
    std::ranges::rotate(cubes, std::ranges::min_element(cubes));
    const bool collapsed = cubes[0] == cubes[1] || cubes[1] == cubes[2] || cubes[2] == cubes[0];
    if (collapsed || !seen.insert(cubes).second) continue;
    result.insert(result.end(), triangle.begin(), triangle.end());
  }
  return result;
}

}  // namespace

double Extent(const Visual& visual) {
  switch (visual.shape) {
    case Visual::Shape::kBox:
      return visual.size.maxCoeff();
    case Visual::Shape::kCylinder:
    case Visual::Shape::kCone:
      return std::max(2 * visual.size.x(), visual.size.z());
    case Visual::Shape::kSphere:
      return 2 * visual.size.x();
    case Visual::Shape::kMesh:
      break;
  }
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& corner : visual.triangles) box.extend(corner);
  return box.isEmpty() ? 0 : static_cast<double>(box.sizes().maxCoeff());
}

void AppendVisual(const Visual& visual, const Eigen::Isometry3d& X_BO, int bone,
                  const Detail& detail, SurfaceMesh& mesh) {
  if (Extent(visual) < detail.min_extent) return;
  VisualWriter writer(visual, X_BO, bone, mesh);
  switch (visual.shape) {
    case Visual::Shape::kBox:
      return WriteBox(visual.size, detail.chamfer, writer);
    case Visual::Shape::kCylinder:
      return WriteRound(visual.size, visual.size.x(), detail, writer);
    case Visual::Shape::kCone:
      return WriteRound(visual.size, 0, detail, writer);
    case Visual::Shape::kSphere:
      return WriteSphere(visual.size.x(), visual.material.texture == "grass", detail, writer);
    case Visual::Shape::kMesh:
      if (detail.cluster > 0) {
        return WriteTriangles(Clustered(visual.triangles, detail.cluster), writer);
      }
      return WriteTriangles(visual.triangles, writer);
  }
}

}  // namespace eod::sim
