#include "sim/sdf/sdf_shape.h"

#include <sdf/Box.hh>
#include <sdf/Capsule.hh>
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

SdfGeometry ToBox(const Eigen::Vector3d& size) {
  return {.kind = Visual::Shape::kBox,
          .size = size,
          .mesh = BoxMesh(size),
          .solid = Primitive{.kind = Primitive::Kind::kBox, .size = size}};
}

SdfGeometry ToCone(double radius, double length) {
  return {.kind = Visual::Shape::kCone,
          .size = {radius, radius, length},
          .mesh = ConeMesh(radius, length, kCylinderSides),
          .solid = std::nullopt};
}

SdfGeometry ToCylinder(double radius, double length) {
  const Eigen::Vector3d size(radius, radius, length);
  return {.kind = Visual::Shape::kCylinder,
          .size = size,
          .mesh = CylinderMesh(radius, length, kCylinderSides),
          .solid = Primitive{.kind = Primitive::Kind::kCylinder, .size = size}};
}

SdfGeometry ToSphere(double radius) {
  const Eigen::Vector3d size = Eigen::Vector3d::Constant(radius);
  return {.kind = Visual::Shape::kSphere,
          .size = size,
          .mesh = SphereMesh(radius, kSphereRings, kCylinderSides),
          .solid = Primitive{.kind = Primitive::Kind::kSphere, .size = size}};
}

/// Drawn as a mesh; nobody else has a word for it.
SdfGeometry ToCapsule(double radius, double length) {
  return {.mesh = CapsuleMesh(radius, length, kSphereRings, kCylinderSides),
          .solid = Primitive{.kind = Primitive::Kind::kCapsule, .size = {radius, radius, length}}};
}

}  // namespace

SdfGeometry ToGeometry(const sdf::Geometry& geometry, const std::vector<CustomElement>& customs,
                       const sdf::ElementPtr& owner, const std::filesystem::path& file) {
  const CustomElement* cone = FindElement(customs, "cone");
  const CustomElement* grid = FindElement(customs, "grid");
  if (cone != nullptr) cone->AllowAttributes({});
  if (grid != nullptr) grid->AllowAttributes({"cell"});
  switch (geometry.Type()) {
    case sdf::GeometryType::BOX: {
      const auto& size = geometry.BoxShape()->Size();
      return ToBox({size.X(), size.Y(), size.Z()});
    }
    case sdf::GeometryType::CYLINDER: {
      const sdf::Cylinder& cylinder = *geometry.CylinderShape();
      return cone != nullptr ? ToCone(cylinder.Radius(), cylinder.Length())
                             : ToCylinder(cylinder.Radius(), cylinder.Length());
    }
    case sdf::GeometryType::SPHERE:
      return ToSphere(geometry.SphereShape()->Radius());
    case sdf::GeometryType::CAPSULE:
      return ToCapsule(geometry.CapsuleShape()->Radius(), geometry.CapsuleShape()->Length());
    case sdf::GeometryType::PLANE: {
      if (geometry.PlaneShape()->Normal() != ignition::math::Vector3d::UnitZ) {
        FailAt(file, LineOf(owner), "plane: only the normal 0 0 1 is supported; turn its pose");
      }
      const auto& size = geometry.PlaneShape()->Size();
      const double cell = grid == nullptr ? 2.0 : grid->Number("cell", 0.1, 100);
      return {.mesh = PlaneMesh(size.X(), size.Y(), cell), .solid = std::nullopt};
    }
    case sdf::GeometryType::MESH:
      return {.mesh = ReadScaledMesh(*geometry.MeshShape(), file), .solid = std::nullopt};
    default:
      FailAt(file, LineOf(owner),
             "geometry: allowed are box, cylinder, sphere, capsule, plane, mesh");
  }
}

Material ToMaterial(const sdf::Material* material, const CustomElement* surface) {
  Material result;
  if (material != nullptr) {
    result.diffuse = ToColour(material->Diffuse());
    result.specular = material->Specular().R();
    result.emissive = ToColour(material->Emissive());
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
