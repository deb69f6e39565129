#include "sim/sdf/sdf_parts.h"

#include <charconv>

#include <fmt/format.h>
#include <sdf/Box.hh>
#include <sdf/Camera.hh>
#include <sdf/Collision.hh>
#include <sdf/Cylinder.hh>
#include <sdf/Geometry.hh>
#include <sdf/Joint.hh>
#include <sdf/JointAxis.hh>
#include <sdf/Material.hh>
#include <sdf/Mesh.hh>
#include <sdf/Plane.hh>
#include <sdf/Sensor.hh>
#include <sdf/Sphere.hh>
#include <sdf/Visual.hh>

#include "sim/geometry/obj_file.h"

namespace eod::sim {

namespace {

constexpr std::string_view kPrefix = "eod:";
constexpr int kCylinderSides = 24;
constexpr int kSphereRings = 8;

CustomElement ToCustom(const sdf::ElementPtr& element, const std::filesystem::path& file) {
  CustomElement custom{.file = file,
                       .line = 0,
                       .name = element->GetName(),
                       .attributes = {},
                       .children = CustomsOf(element, file)};
  custom.name.erase(0, kPrefix.size());
  for (const sdf::ParamPtr& attribute : element->GetAttributes()) {
    const std::string value = attribute->GetAsString();
    if (attribute->GetKey() == "eod:line") {
      std::from_chars(value.data(), value.data() + value.size(), custom.line);
    } else {
      custom.attributes.emplace(attribute->GetKey(), value);
    }
  }
  return custom;
}

/// A shape that both a visual and a collision can have.
struct Shape {
  Visual::Shape kind = Visual::Shape::kMesh;
  Eigen::Vector3d size = Eigen::Vector3d::Ones();
  Mesh mesh;
};

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

/// `customs` may say that a cylinder tapers to a cone, and how finely a plane is cut.
Shape ToShape(const sdf::Geometry& geometry, const std::vector<CustomElement>& customs,
              const sdf::ElementPtr& owner, const std::filesystem::path& file) {
  const CustomElement* cone = FindElement(customs, "cone");
  const CustomElement* grid = FindElement(customs, "grid");
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

SdfVisual ToVisual(const sdf::Visual& visual, const std::filesystem::path& file) {
  const auto customs = CustomsOf(visual.Element(), file);
  AllowElements(customs, {"surface", "cone", "grid"}, "visual " + visual.Name());
  const Shape shape = ToShape(*visual.Geom(), customs, visual.Element(), file);
  SdfVisual result{.name = visual.Name(), .visual = {}};
  result.visual.shape = shape.kind;
  result.visual.size = shape.size;
  result.visual.X_OV = Resolve(visual.SemanticPose(), "", visual.Element(), file);
  result.visual.material = ToMaterial(visual.Material(), FindElement(customs, "surface"));
  if (shape.kind == Visual::Shape::kMesh) {
    for (const Triangle& triangle : shape.mesh) {
      for (const Eigen::Vector3d& corner : triangle) {
        result.visual.triangles.push_back(corner.cast<float>());
      }
    }
  }
  return result;
}

SdfCollision ToCollision(const sdf::Collision& collision, const std::filesystem::path& file) {
  const auto customs = CustomsOf(collision.Element(), file);
  AllowElements(customs, {"proxy", "cone", "grid"}, "collision " + collision.Name());
  Shape shape = ToShape(*collision.Geom(), customs, collision.Element(), file);
  SdfCollision result{.name = collision.Name(), .triangles = {}};
  result.triangles = Transformed(Resolve(collision.SemanticPose(), "", collision.Element(), file),
                                 std::move(shape.mesh));
  if (const CustomElement* proxy = FindElement(customs, "proxy")) {
    proxy->AllowAttributes({"kind"});
    const std::string& kind = proxy->Text("kind");
    if (kind != "clamp" && kind != "bump" && kind != "both") {
      proxy->Fail(fmt::format("kind = \"{}\" of <eod:proxy>: allowed clamp, bump, both", kind));
    }
    result.clamp = kind != "bump";
    result.bump = kind != "clamp";
  }
  return result;
}

SdfCamera ToCamera(const sdf::Sensor& sensor, const std::filesystem::path& file) {
  const sdf::Camera* camera = sensor.CameraSensor();
  if (camera == nullptr) {
    FailAt(file, LineOf(sensor.Element()),
           fmt::format("sensor {}: only the type camera is supported", sensor.Name()));
  }
  return {.name = sensor.Name(),
          .line = LineOf(sensor.Element()),
          .X_LS = Resolve(sensor.SemanticPose(), "", sensor.Element(), file),
          .horizontal_fov = camera->HorizontalFov().Radian(),
          .width = static_cast<int>(camera->ImageWidth()),
          .height = static_cast<int>(camera->ImageHeight())};
}

SdfJoint ToJoint(const sdf::Joint& joint, const std::filesystem::path& file) {
  SdfJoint result{
      .name = joint.Name(),
      .line = LineOf(joint.Element()),
      .type = joint.Element()->GetAttribute("type")->GetAsString(),
      .parent = joint.ParentLinkName(),
      .child = joint.ChildLinkName(),
      .X_LJ = Resolve(joint.SemanticPose(), joint.ChildLinkName(), joint.Element(), file),
      .customs = CustomsOf(joint.Element(), file)};
  if (const sdf::JointAxis* axis = joint.Axis()) {
    ignition::math::Vector3d direction;
    const sdf::Errors errors = axis->ResolveXyz(direction, joint.ChildLinkName());
    if (!errors.empty()) FailAt(file, result.line, errors.front().Message());
    result.axis = {direction.X(), direction.Y(), direction.Z()};
    result.lower = axis->Lower();
    result.upper = axis->Upper();
    result.velocity = axis->MaxVelocity();
  }
  return result;
}

}  // namespace

int LineOf(const sdf::ElementPtr& element) {
  return element && element->LineNumber() ? *element->LineNumber() : 0;
}

std::vector<CustomElement> CustomsOf(const sdf::ElementPtr& element,
                                     const std::filesystem::path& file) {
  std::vector<CustomElement> customs;
  for (auto child = element->GetFirstElement(); child; child = child->GetNextElement()) {
    if (child->GetName().starts_with(kPrefix)) customs.push_back(ToCustom(child, file));
  }
  return customs;
}

Eigen::Isometry3d ToIsometry(const ignition::math::Pose3d& pose) {
  const auto& q = pose.Rot();
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = Eigen::Quaterniond(q.W(), q.X(), q.Y(), q.Z()).normalized().toRotationMatrix();
  X.translation() = Eigen::Vector3d(pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z());
  return X;
}

Eigen::Vector3f ToColour(const ignition::math::Color& colour) {
  return {colour.R(), colour.G(), colour.B()};
}

Eigen::Isometry3d Resolve(const sdf::SemanticPose& pose, const std::string& frame,
                          const sdf::ElementPtr& element, const std::filesystem::path& file) {
  ignition::math::Pose3d resolved;
  const sdf::Errors errors = pose.Resolve(resolved, frame);
  if (!errors.empty()) FailAt(file, LineOf(element), errors.front().Message());
  return ToIsometry(resolved);
}

SdfLink ToLink(const sdf::Link& link, const std::filesystem::path& file) {
  SdfLink result{.name = link.Name(),
                 .line = LineOf(link.Element()),
                 .X_ML = Resolve(link.SemanticPose(), "__model__", link.Element(), file),
                 .visuals = {},
                 .collisions = {},
                 .cameras = {},
                 .customs = CustomsOf(link.Element(), file)};
  for (uint64_t i = 0; i < link.VisualCount(); ++i) {
    result.visuals.push_back(ToVisual(*link.VisualByIndex(i), file));
  }
  for (uint64_t i = 0; i < link.CollisionCount(); ++i) {
    result.collisions.push_back(ToCollision(*link.CollisionByIndex(i), file));
  }
  for (uint64_t i = 0; i < link.SensorCount(); ++i) {
    result.cameras.push_back(ToCamera(*link.SensorByIndex(i), file));
  }
  return result;
}

SdfModel ToModel(const sdf::Model& model, const std::filesystem::path& file) {
  SdfModel result{.name = model.Name(),
                  .line = LineOf(model.Element()),
                  .is_static = model.Static(),
                  .relative_to = model.PoseRelativeTo(),
                  .X_FM = ToIsometry(model.RawPose()),
                  .links = {},
                  .joints = {},
                  .customs = CustomsOf(model.Element(), file)};
  for (uint64_t i = 0; i < model.LinkCount(); ++i) {
    result.links.push_back(ToLink(*model.LinkByIndex(i), file));
  }
  for (uint64_t i = 0; i < model.JointCount(); ++i) {
    result.joints.push_back(ToJoint(*model.JointByIndex(i), file));
  }
  return result;
}

}  // namespace eod::sim
