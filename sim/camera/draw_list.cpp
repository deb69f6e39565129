#include "sim/camera/draw_list.h"

#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>

#include "sim/camera/surface_textures.h"

namespace eod::sim {
namespace {

constexpr double kCell = 20.0;  // [m]
constexpr double kWorldChamfer = 0.012;
constexpr double kRobotChamfer = 0.008;

void AppendRange(const SurfaceMesh& part, int texture, DrawList& list) {
  DrawRange range{.texture = texture,
                  .first = static_cast<uint32_t>(list.mesh.indices.size()),
                  .count = static_cast<uint32_t>(part.indices.size()),
                  .bounds = {},
                  .casts_shadow = true};
  const auto base = static_cast<uint32_t>(list.mesh.vertices.size());
  for (const Vertex& vertex : part.vertices) {
    range.bounds.extend(Eigen::Vector3f(vertex.position));
    list.mesh.vertices.push_back(vertex);
  }
  for (const uint32_t index : part.indices) list.mesh.indices.push_back(base + index);
  list.ranges.push_back(range);
}

/// Flat ground takes shadows but throws none; leaving it out saves filling the whole shadow map.
bool IsFlatGround(const DrawRange& range) { return range.bounds.max().z() < 0.03F; }

int TextureOf(const Visual& visual, const std::filesystem::path& file) {
  try {
    return SurfaceTextureIndex(visual.material.texture);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", file.string(), error.what()));
  }
}

}  // namespace

DrawList BuildWorldDrawList(const ModuleModel& module) {
  std::map<std::tuple<int, int, int>, SurfaceMesh> parts;
  for (const WorldObject& object : module.objects) {
    for (const Visual& visual : object.visuals) {
      const Eigen::Vector3d centre = object.X_MO * visual.X_OV.translation();
      const auto cell = [](double coordinate) {
        return static_cast<int>(std::floor(coordinate / kCell));
      };
      SurfaceMesh& part =
          parts[{TextureOf(visual, object.name), cell(centre.x()), cell(centre.y())}];
      AppendVisual(visual, object.X_MO, 0, kWorldChamfer, part);
    }
  }
  DrawList list;
  for (const auto& [key, part] : parts) AppendRange(part, std::get<0>(key), list);
  for (DrawRange& range : list.ranges) range.casts_shadow = !IsFlatGround(range);
  return list;
}

DrawList BuildRobotDrawList(const RobotModel& robot) {
  std::map<int, SurfaceMesh> parts;
  for (const LinkVisual& link_visual : robot.visuals) {
    AppendVisual(link_visual.visual, Eigen::Isometry3d::Identity(), 1 + link_visual.link,
                 kRobotChamfer, parts[TextureOf(link_visual.visual, robot.file)]);
  }
  DrawList list;
  for (const auto& [texture, part] : parts) AppendRange(part, texture, list);
  return list;
}

}  // namespace eod::sim
