#include "sim/sdf/sdf_shape.h"

#include <sdf/Box.hh>
#include <sdf/Cylinder.hh>
#include <sdf/Mesh.hh>
#include <sdf/Plane.hh>
#include <sdf/Sphere.hh>

#include "sim/geometry/obj_file.h"
#include "sim/sdf/sdf_parts.h"

namespace eod::sim {

namespace {

constexpr int kCylinderSides = 24;
constexpr int kSphereRings = 8;

Mesh ReadScaledMesh(const sdf::Mesh& mesh, const std::filesystem::path& file) {
  Mesh triangles = ReadObj(file.parent_path() / mesh.Uri());
  const Eigen::Vector3d scale(mesh.Scale().X(), mesh.Scale().Y(), mesh.Scale().Z());
  for (Triangle& triangle : triangles) {
    for (Eigen::Vector3d& corner : triangle) corner = corner.cwiseProduct(scale);
  }
  return triangles;
}

Shape ToRoundShape(double radius, double length, bool is_cone) {
  return {.kind = is_cone ? Visual::Shape::kCone : Visual::Shape::kCylinder,
          .size = {radius, radius, length},
          .mesh = is_cone ? ConeMesh(radius, length, kCylinderSides)
                          : CylinderMesh(radius, length, kCylinderSides)};
}

}  // namespace

Shape ToShape(const sdf::Geometry& geometry, const std::vector<CustomElement>& customs,
              const sdf::ElementPtr& owner, const std::filesystem::path& file) {
  const CustomElement* cone = FindElement(customs, "cone");
  const CustomElement* grid = FindElement(customs, "grid");
  if (cone != nullptr) cone->AllowAttributes({});
  if (grid != nullptr) grid->AllowAttributes({"cell"});
  switch (geometry.Type()) {
    case sdf::GeometryType::BOX: {
      const auto& size = geometry.BoxShape()->Size();
      const Eigen::Vector3d whole(size.X(), size.Y(), size.Z());
      return {.kind = Visual::Shape::kBox, .size = whole, .mesh = BoxMesh(whole)};
    }
    case sdf::GeometryType::CYLINDER:
      return ToRoundShape(geometry.CylinderShape()->Radius(), geometry.CylinderShape()->Length(),
                          cone != nullptr);
    case sdf::GeometryType::SPHERE: {
      const double radius = geometry.SphereShape()->Radius();
      return {.kind = Visual::Shape::kSphere,
              .size = Eigen::Vector3d::Constant(radius),
              .mesh = SphereMesh(radius, kSphereRings, kCylinderSides)};
    }
    case sdf::GeometryType::PLANE: {
      if (geometry.PlaneShape()->Normal() != ignition::math::Vector3d::UnitZ) {
        FailAt(file, LineOf(owner), "plane: only the normal 0 0 1 is supported; turn its pose");
      }
      const auto& size = geometry.PlaneShape()->Size();
      const double cell = grid == nullptr ? 2.0 : grid->Number("cell", 0.1, 100);
      return {.mesh = PlaneMesh(size.X(), size.Y(), cell)};
    }
    case sdf::GeometryType::MESH:
      return {.mesh = ReadScaledMesh(*geometry.MeshShape(), file)};
    default:
      FailAt(file, LineOf(owner), "geometry: allowed are box, cylinder, sphere, plane and mesh");
  }
}

Material ToMaterial(const sdf::Material* material, const CustomElement* surface) {
  Material result;
  if (material != nullptr) {
    result.diffuse = ToColour(material->Diffuse());
    result.specular = material->Specular().R();
  }
  if (surface != nullptr) {
    surface->AllowAttributes({"texture", "tile"});
    result.texture = surface->Text("texture");
    if (surface->Has("tile")) {
      result.texture_scale_m = static_cast<float>(surface->Number("tile", 0.01, 1000));
    }
  }
  return result;
}

}  // namespace eod::sim
