#include "sim/world/movable_loader.h"

#include <stdexcept>

#include <fmt/format.h>

#include "sim/geometry/object_class.h"

namespace eod::sim {

namespace {

constexpr double kSamePose = 1e-9;

bool IsUpright(const Eigen::Isometry3d& X) {
  return X.linear().col(2).isApprox(Eigen::Vector3d::UnitZ(), kSamePose);
}

MovablePart ReadPart(const SdfCollision& collision, const Eigen::Isometry3d& X_OL,
                     const std::filesystem::path& file) {
  if (!collision.solid) {
    FailAt(file, collision.line,
           fmt::format("collision {} of a model that moves: allowed are box, cylinder, sphere and "
                       "capsule",
                       collision.name));
  }
  if (!collision.clamp || !collision.bump) {
    FailAt(file, collision.line,
           fmt::format("collision {} of a model that moves: takes no <eod:proxy>", collision.name));
  }
  try {
    return {.shape = Shape::Of(*collision.solid), .X_OS = X_OL * collision.solid->X_OP};
  } catch (const std::runtime_error& error) {
    FailAt(file, collision.line, fmt::format("collision {}: {}", collision.name, error.what()));
  }
}

ExplosiveSpec ReadExplosive(const CustomElement& element, const MovableObject& object) {
  element.AllowAttributes({});
  const auto* cylinder = object.parts.size() == 1
                             ? std::get_if<CylinderSolid>(&object.parts[0].shape.solid())
                             : nullptr;
  const Eigen::Isometry3d& X_OS = object.parts[0].X_OS;
  if (cylinder == nullptr || !IsUpright(X_OS) || X_OS.translation().norm() > kSamePose) {
    element.Fail(fmt::format(
        "model {}: <eod:explosive> needs one collision, a cylinder centred on the model and "
        "upright in it",
        object.name));
  }
  return {.radius = cylinder->radius, .half_height = cylinder->half_length};
}

const SdfLink& OnlyLink(const SdfModel& model, const std::filesystem::path& file) {
  if (model.links.size() != 1 || !model.joints.empty()) {
    FailAt(file, model.line,
           fmt::format("model {} moves: {} links and {} joints, needs one link and no joint",
                       model.name, model.links.size(), model.joints.size()));
  }
  const SdfLink& link = model.links[0];
  AllowElements(link.customs, {}, fmt::format("link {} of model {}", link.name, model.name));
  if (!(link.mass > 0)) {
    FailAt(file, link.line,
           fmt::format("link {} of model {} moves: needs <inertial> with a <mass> above 0 kg",
                       link.name, model.name));
  }
  if (link.collisions.empty()) {
    FailAt(file, link.line,
           fmt::format("link {} of model {} moves: needs a <collision>", link.name, model.name));
  }
  return link;
}

}  // namespace

MovableObject ReadMovable(const SdfModel& model, uint32_t module_bit,
                          const std::filesystem::path& file) {
  AllowElements(model.customs, {"movable", "explosive"}, "model " + model.name);
  const CustomElement* movable = FindElement(model.customs, "movable");
  if (movable == nullptr) {
    FailAt(file, model.line,
           fmt::format("model {}: needs <static>true</static>, or <eod:movable friction=\"…\"/>",
                       model.name));
  }
  movable->AllowAttributes({"friction", "rolling_m"});
  const SdfLink& link = OnlyLink(model, file);
  MovableObject object;
  object.name = model.name;
  object.X_MO = model.X_FM;
  object.mass = link.mass;
  object.p_OC = link.X_ML * link.p_LC;
  object.friction = movable->Number("friction", 0, 2);
  if (movable->Has("rolling_m")) object.rolling = movable->Number("rolling_m", 0, 0.1);
  for (const SdfCollision& collision : link.collisions) {
    object.parts.push_back(ReadPart(collision, link.X_ML, file));
  }
  for (const SdfVisual& visual : link.visuals) {
    object.visuals.push_back(visual.visual);
    object.visuals.back().X_OV = link.X_ML * visual.visual.X_OV;
  }
  const CustomElement* explosive = FindElement(model.customs, "explosive");
  if (explosive != nullptr) object.explosive = ReadExplosive(*explosive, object);
  object.object_class = module_bit | kBumpProxy | (object.explosive ? kBombObject : kMovableObject);
  return object;
}

VesselSpec ReadVessel(const CustomElement& element, const SdfModel& model) {
  const std::string& kind = element.Text("kind");
  if (kind != "drum" && kind != "chamber") {
    element.Fail(fmt::format("kind = \"{}\" of <eod:vessel>: allowed drum, chamber", kind));
  }
  if (!IsUpright(model.X_FM)) {
    element.Fail(fmt::format("model {}: a vessel stands upright; only a turn about Z is allowed",
                             model.name));
  }
  VesselSpec vessel;
  vessel.name = model.name;
  vessel.X_MV = model.X_FM;
  if (kind == "drum") {
    element.AllowAttributes({"kind", "inner_radius_m", "net_m", "rim_m"});
    vessel.inner_radius = element.Number("inner_radius_m", 0.05, 10);
  } else {
    element.AllowAttributes({"kind", "inner_x_m", "inner_y_m", "net_m", "rim_m"});
    vessel.half_size.x() = element.Number("inner_x_m", 0.1, 20) / 2;
    vessel.half_size.y() = element.Number("inner_y_m", 0.1, 20) / 2;
  }
  vessel.net_z = element.Number("net_m", 0, 10);
  vessel.rim_z = element.Number("rim_m", 0, 10);
  if (vessel.net_z >= vessel.rim_z) {
    element.Fail(fmt::format("net_m = {} of <eod:vessel>: needs to be below rim_m = {}",
                             vessel.net_z, vessel.rim_z));
  }
  return vessel;
}

}  // namespace eod::sim
