#include "sim/sdf/sdf_parts.h"

#include <charconv>

#include <fmt/format.h>
#include <sdf/Camera.hh>
#include <sdf/Collision.hh>
#include <sdf/Joint.hh>
#include <sdf/JointAxis.hh>
#include <sdf/Sensor.hh>
#include <sdf/Visual.hh>

#include "sim/sdf/sdf_shape.h"

namespace eod::sim {

namespace {

constexpr std::string_view kPrefix = "eod:";

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

SdfVisual ToVisual(const sdf::Visual& visual, const std::filesystem::path& file) {
  const auto customs = CustomsOf(visual.Element(), file);
  AllowElements(customs, {"surface", "cone", "grid"}, "visual " + visual.Name());
  const SdfGeometry shape = ToGeometry(*visual.Geom(), customs, visual.Element(), file);
  SdfVisual result{.name = visual.Name(), .visual = {}};
  result.visual.shape = shape.kind;
  result.visual.size = shape.size;
  result.visual.X_OV = Resolve(visual.SemanticPose(), "", visual.Element(), file);
  result.visual.material = ToMaterial(visual.Material(), FindElement(customs, "surface"));
  result.visual.casts_shadow = visual.CastShadows();
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
  SdfGeometry shape = ToGeometry(*collision.Geom(), customs, collision.Element(), file);
  const Eigen::Isometry3d X_LP = Resolve(collision.SemanticPose(), "", collision.Element(), file);
  SdfCollision result{.name = collision.Name(),
                      .line = LineOf(collision.Element()),
                      .triangles = Transformed(X_LP, std::move(shape.mesh)),
                      .solid = shape.solid};
  if (result.solid) result.solid->X_OP = X_LP;
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
          .near = camera->NearClip(),
          .width = static_cast<int>(camera->ImageWidth()),
          .height = static_cast<int>(camera->ImageHeight()),
          .customs = CustomsOf(sensor.Element(), file)};
}

void CheckLight(const SdfLight& light, const std::filesystem::path& file) {
  const Falloff& falloff = light.light.falloff;
  const auto check = [&](bool is_good, const char* what) {
    if (!is_good) FailAt(file, light.line, fmt::format("light {}: {}", light.name, what));
  };
  check(falloff.range > 0 && falloff.range <= 1000, "<range> allowed 0..1000 m, not 0");
  check(falloff.constant >= 0 && falloff.linear >= 0 && falloff.quadratic >= 0,
        "<constant>, <linear>, <quadratic> must not be negative");
  check(falloff.constant > 0 || falloff.linear > 0 || falloff.quadratic > 0,
        "one of <constant>, <linear>, <quadratic> must be positive");
  check((light.light.colour.array() >= 0).all(), "<intensity> must not be negative");
  if (!light.is_spot) return;
  check(light.outer_angle > 0 && light.outer_angle < 3.1, "<outer_angle> allowed 0..3.1, not 0");
  check(light.inner_angle >= 0 && light.inner_angle < light.outer_angle,
        "<inner_angle> must be smaller than <outer_angle>");
  check(light.direction.norm() > 1e-6, "<direction> must not be zero");
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

SdfLight ToLight(const sdf::Light& light, bool is_of_world, const std::filesystem::path& file) {
  const auto direction = light.Direction();
  SdfLight result{
      .name = light.Name(),
      .line = LineOf(light.Element()),
      .is_spot = light.Type() == sdf::LightType::SPOT,
      .relative_to = is_of_world ? light.PoseRelativeTo() : "",
      .X_FS = is_of_world ? ToIsometry(light.RawPose())
                          : Resolve(light.SemanticPose(), "", light.Element(), file),
      .direction = {direction.X(), direction.Y(), direction.Z()},
      .light = {.colour = ToColour(light.Diffuse()) * static_cast<float>(light.Intensity()),
                .falloff = {.range = light.AttenuationRange(),
                            .constant = light.ConstantAttenuationFactor(),
                            .linear = light.LinearAttenuationFactor(),
                            .quadratic = light.QuadraticAttenuationFactor()}},
      .inner_angle = light.SpotInnerAngle().Radian(),
      .outer_angle = light.SpotOuterAngle().Radian(),
      .customs = CustomsOf(light.Element(), file)};
  CheckLight(result, file);
  result.direction.normalize();
  return result;
}

SdfLink ToLink(const sdf::Link& link, const std::filesystem::path& file) {
  SdfLink result{.name = link.Name(),
                 .line = LineOf(link.Element()),
                 .X_ML = Resolve(link.SemanticPose(), "__model__", link.Element(), file),
                 .mass = 0,
                 .p_LC = Eigen::Vector3d::Zero(),
                 .visuals = {},
                 .collisions = {},
                 .cameras = {},
                 .lights = {},
                 .customs = CustomsOf(link.Element(), file)};
  // Without <inertial>, libsdformat would have it weigh 1 kg.
  if (link.Element()->HasElement("inertial")) {
    result.mass = link.Inertial().MassMatrix().Mass();
    result.p_LC = ToIsometry(link.Inertial().Pose()).translation();
  }
  for (uint64_t i = 0; i < link.VisualCount(); ++i) {
    result.visuals.push_back(ToVisual(*link.VisualByIndex(i), file));
  }
  for (uint64_t i = 0; i < link.CollisionCount(); ++i) {
    result.collisions.push_back(ToCollision(*link.CollisionByIndex(i), file));
  }
  for (uint64_t i = 0; i < link.SensorCount(); ++i) {
    result.cameras.push_back(ToCamera(*link.SensorByIndex(i), file));
  }
  for (uint64_t i = 0; i < link.LightCount(); ++i) {
    result.lights.push_back(ToLight(*link.LightByIndex(i), false, file));
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
