#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "sim/robot/robot_model.h"
#include "sim/robot/robot_parts.h"

namespace eod::sim {

namespace {

/// Our cameras look along +Y, those of SDFormat along +X.
Eigen::Isometry3d ForwardAlongY(const Eigen::Isometry3d& X_LS) {
  return X_LS * Eigen::AngleAxisd(-std::numbers::pi / 2, Eigen::Vector3d::UnitZ());
}

void ReadZoom(const SdfCamera& camera, CameraSpec& spec) {
  AllowElements(camera.customs, {"zoom"}, "camera " + camera.name);
  const CustomElement* zoom = FindElement(camera.customs, "zoom");
  if (zoom == nullptr) return;
  zoom->AllowAttributes({"narrowest_deg", "factor_per_s"});
  const double widest_deg = spec.horizontal_fov * 180 / std::numbers::pi;
  const double narrowest = zoom->Number("narrowest_deg", 0.5, widest_deg) * std::numbers::pi / 180;
  spec.zoom_most = std::tan(spec.horizontal_fov / 2) / std::tan(narrowest / 2);
  spec.zoom_per_s = zoom->Number("factor_per_s", 1.01, 100);
}

CameraSpec ToCameraSpec(const SdfCamera& camera, int link, const std::filesystem::path& file) {
  if (camera.width < 16 || camera.width > 4096 || camera.height < 16 || camera.height > 4096) {
    FailAt(file, camera.line,
           fmt::format("camera {}: {} x {} pixels, allowed 16..4096", camera.name, camera.width,
                       camera.height));
  }
  if (camera.near < 0.005 || camera.near > 1) {
    FailAt(file, camera.line,
           fmt::format("camera {}: near {} m, allowed 0.005..1", camera.name, camera.near));
  }
  CameraSpec spec{.name = camera.name,
                  .link = link,
                  .X_LC = ForwardAlongY(camera.X_LS),
                  .horizontal_fov = camera.horizontal_fov,
                  .near = camera.near,
                  .width = camera.width,
                  .height = camera.height};
  ReadZoom(camera, spec);
  return spec;
}

void ReadChassis(const SdfModel& sdf, RobotModel& model) {
  const CustomElement* chassis = FindElement(sdf.customs, "chassis");
  if (chassis == nullptr) {
    FailAt(model.file, sdf.line, fmt::format("model {} needs <eod:chassis>", sdf.name));
  }
  chassis->AllowAttributes({"creep_mps", "low_mps", "high_mps", "turn_deg_per_s", "accel_mps2",
                            "turn_accel_deg_per_s2", "step_up_m", "fall_search_m", "track_m"});
  model.drive_speed = {chassis->Number("creep_mps", 0.01, 5), chassis->Number("low_mps", 0.01, 5),
                       chassis->Number("high_mps", 0.01, 5)};
  model.turn_rate = chassis->Number("turn_deg_per_s", 1, 360) * std::numbers::pi / 180;
  if (chassis->Has("accel_mps2")) {
    model.drive_acceleration = chassis->Number("accel_mps2", 0.01, 100);
  }
  if (chassis->Has("turn_accel_deg_per_s2")) {
    model.turn_acceleration =
        chassis->Number("turn_accel_deg_per_s2", 0.1, 1e4) * std::numbers::pi / 180;
  }
  if (chassis->Has("track_m")) model.track = chassis->Number("track_m", 0.05, 5);
  model.step_up_limit = chassis->Number("step_up_m", 0.01, 2);
  model.fall_search = chassis->Number("fall_search_m", 0.1, 100);
}

void ReadLinkContents(const SdfLink& link, int index, RobotModel& model) {
  AllowElements(link.customs, {"isector"}, "link " + link.name);
  for (const CustomElement& custom : link.customs) {
    if (FindIsector(model, custom.Text("name")) >= 0) {
      custom.Fail(fmt::format("second isector {}", custom.Text("name")));
    }
    model.isectors.push_back(ReadIsector(custom, index, model));
  }
  for (const SdfCollision& collision : link.collisions) {
    if (!collision.solid) {
      FailAt(model.file, collision.line,
             fmt::format("collision {} of link {}: allowed are box, cylinder, sphere and capsule",
                         collision.name, link.name));
    }
    model.links[static_cast<size_t>(index)].solids.push_back(
        {.shape = Shape::Of(*collision.solid), .X_LS = collision.solid->X_OP});
  }
  for (const SdfCamera& camera : link.cameras) {
    model.cameras.push_back(ToCameraSpec(camera, index, model.file));
  }
  for (const SdfLight& light : link.lights) {
    model.lights.push_back(ReadLight(light, index, model.file));
  }
  for (const SdfVisual& visual : link.visuals) {
    model.visuals.push_back({.link = index, .visual = visual.visual});
  }
}

void RequireTripod(const SdfModel& sdf, const RobotModel& model) {
  const auto tripods = std::count_if(
      model.isectors.begin(), model.isectors.end(),
      [](const IsectorSpec& isector) { return isector.method == IsectorMethod::kTripod; });
  if (tripods != 1) {
    FailAt(model.file, sdf.line,
           fmt::format("model {}: {} isectors of method tripod, needs one", sdf.name, tripods));
  }
}

void RequireCameras(const SdfModel& sdf, const RobotModel& model) {
  for (const char* name : {"drive", "gripper", "mast", "rear"}) {
    const bool given =
        std::any_of(model.cameras.begin(), model.cameras.end(),
                    [name](const CameraSpec& camera) { return camera.name == name; });
    if (!given) {
      FailAt(model.file, sdf.line, fmt::format("model {}: camera {} is missing", sdf.name, name));
    }
  }
}

}  // namespace

RobotModel LoadRobot(const std::filesystem::path& file) {
  const SdfModel sdf = ReadSdfModel(file);
  AllowElements(sdf.customs, {"battery", "chassis", "payload", "preset", "stance"},
                "model " + sdf.name);
  RobotModel model;
  model.file = file;
  model.name = sdf.name;
  ReadChassis(sdf, model);
  LinkTree tree = ReadLinks(sdf, file);
  model.links = std::move(tree.links);
  model.joints = ReadJoints(sdf, file, model.links);
  model.presets = ReadPresets(sdf, model.joints);
  model.payload = ReadPayload(sdf);
  model.battery = ReadBattery(sdf);
  model.stance = ReadStance(sdf, model);
  for (size_t i = 0; i < model.links.size(); ++i) {
    ReadLinkContents(sdf.links[static_cast<size_t>(tree.order[i])], static_cast<int>(i), model);
  }
  RequireTripod(sdf, model);
  RequireCameras(sdf, model);
  return model;
}

}  // namespace eod::sim
