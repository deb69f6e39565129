#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/sdf/sdf_file.h"
#include "sim/world/movable_loader.h"
#include "sim/world/world_model.h"

namespace eod::sim {

namespace {

constexpr int kModules = 5;

/// A module, and the frame of the file that its objects are posed in.
struct FramedModule {
  ModuleModel module;
  std::string frame;
};

FramedModule ReadModule(const CustomElement& element, const SdfWorld& sdf) {
  element.AllowAttributes({"id", "name", "frame", "size_x_m", "size_y_m", "start_heading_deg"});
  FramedModule result;
  result.frame = element.Text("frame");
  const auto frame = std::find_if(sdf.frames.begin(), sdf.frames.end(),
                                  [&](const SdfFrame& one) { return one.name == result.frame; });
  if (frame == sdf.frames.end()) {
    element.Fail(
        fmt::format("frame = \"{}\" of <eod:module>: the world has no such frame", result.frame));
  }
  if (!frame->X_WF.linear().isIdentity(1e-12)) {
    element.Fail(
        fmt::format("frame {} of <eod:module> is turned; only a shift is allowed", result.frame));
  }
  ModuleModel& module = result.module;
  module.id = element.Integer("id", 1, kModules);
  module.name = element.Text("name");
  module.class_bit = 1u << (module.id - 1);
  module.p_WM = frame->X_WF.translation();
  module.half_size = {element.Number("size_x_m", 1, 3000) / 2,
                      element.Number("size_y_m", 1, 3000) / 2};
  if (element.Has("start_heading_deg")) {
    module.start_attitude.heading =
        WrapHeading(element.Number("start_heading_deg", -360, 360) * std::numbers::pi / 180);
  }
  return result;
}

void AddModel(const SdfModel& model, const std::filesystem::path& file, ModuleModel& module) {
  if (!model.is_static) {
    module.movables.push_back(ReadMovable(model, module.class_bit, file));
    return;
  }
  AllowElements(model.customs, {"vessel"}, "model " + model.name);
  const CustomElement* vessel = FindElement(model.customs, "vessel");
  if (vessel != nullptr) module.vessels.push_back(ReadVessel(*vessel, model));
  const uint32_t kind = vessel != nullptr ? kContainmentVessel : 0u;
  const int object = static_cast<int>(module.objects.size());
  WorldObject& added = module.objects.emplace_back(
      WorldObject{.name = model.name, .X_MO = model.X_FM, .is_static = true, .visuals = {}});
  for (const SdfLink& link : model.links) {
    AllowElements(link.customs, {}, fmt::format("link {} of model {}", link.name, model.name));
    for (const SdfVisual& visual : link.visuals) {
      added.visuals.push_back(visual.visual);
      added.visuals.back().X_OV = link.X_ML * visual.visual.X_OV;
    }
    for (const SdfCollision& collision : link.collisions) {
      const uint32_t proxies =
          (collision.clamp ? kClampProxy : 0u) | (collision.bump ? kBumpProxy : 0u);
      for (const Triangle& corner : Transformed(model.X_FM * link.X_ML, collision.triangles)) {
        module.triangles.push_back({corner, module.class_bit | kind | proxies, object});
      }
    }
  }
}

void AddLamp(const SdfLight& light, const std::filesystem::path& file, ModuleModel& module) {
  AllowElements(light.customs, {}, "light " + light.name);
  if (light.is_spot) {
    FailAt(file, light.line,
           fmt::format("light {}: of the world, only directional and point are supported",
                       light.name));
  }
  module.lamps.push_back(
      {.name = light.name, .p_M = light.X_FS.translation(), .light = light.light});
}

Atmosphere ReadAtmosphere(const SdfWorld& sdf) {
  Atmosphere air;
  if (sdf.sun) {
    air.sun_direction = -sdf.sun->direction;
    air.sun_colour = sdf.sun->colour;
  }
  if (sdf.background) air.sky_colour = *sdf.background;
  if (sdf.fog) {
    air.fog_colour = sdf.fog->colour;
    air.fog_density = sdf.fog->density;
  }
  return air;
}

}  // namespace

const ModuleModel& WorldModel::Module(int id) const {
  std::vector<std::string> there;
  for (const ModuleModel& module : modules) {
    if (module.id == id) return module;
    there.push_back(fmt::format("{} ({})", module.id, module.name));
  }
  FailAt(file, 0, fmt::format("has no module {}, only {}", id, fmt::join(there, ", ")));
}

WorldModel LoadWorld(const std::filesystem::path& file) {
  const SdfWorld sdf = ReadSdfWorld(file);
  AllowElements(sdf.customs, {"module"}, "world " + sdf.name);
  std::vector<FramedModule> framed;
  for (const CustomElement& element : sdf.customs) {
    framed.push_back(ReadModule(element, sdf));
    const auto same = std::count_if(framed.begin(), framed.end(), [&](const FramedModule& one) {
      return one.module.id == framed.back().module.id;
    });
    if (same > 1) element.Fail(fmt::format("second module {}", framed.back().module.id));
  }
  if (framed.empty()) FailAt(file, sdf.line, "world needs an <eod:module>");
  const auto owner_of = [&](const auto& one, const char* kind) -> ModuleModel& {
    const auto owner = std::find_if(framed.begin(), framed.end(), [&](const FramedModule& module) {
      return module.frame == one.relative_to;
    });
    if (owner != framed.end()) return owner->module;
    FailAt(
        file, one.line,
        fmt::format("{} {}: its <pose> needs relative_to=\"FRAME\" of a module", kind, one.name));
  };
  for (const SdfModel& model : sdf.models) AddModel(model, file, owner_of(model, "model"));
  for (const SdfLight& light : sdf.lights) AddLamp(light, file, owner_of(light, "light"));
  WorldModel world{.file = file, .modules = {}, .atmosphere = ReadAtmosphere(sdf)};
  for (FramedModule& one : framed) world.modules.push_back(std::move(one.module));
  return world;
}

}  // namespace eod::sim
