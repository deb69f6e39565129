#include "sim/camera/draw_list.h"

#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>

#include "sim/camera/surface_textures.h"

namespace eod::sim {
namespace {

constexpr double kCell = 15.0;        // [m]
constexpr float kLandscape = 400.0F;  // [m] across
constexpr Detail kFineWorld{.chamfer = 0.02};
constexpr Detail kCoarseWorld{.max_segments = 10, .min_extent = 0.05};
constexpr Detail kFineThing{.chamfer = 0.006};
constexpr Detail kCoarseThing{.max_segments = 12, .min_extent = 0.05};

/// The same shapes twice.
struct Tessellation {
  SurfaceMesh fine;
  SurfaceMesh coarse;
};

IndexRun AppendMesh(const SurfaceMesh& mesh, DrawList& list) {
  const IndexRun run{static_cast<uint32_t>(list.mesh.indices.size()),
                     static_cast<uint32_t>(mesh.indices.size())};
  const auto base = static_cast<uint32_t>(list.mesh.vertices.size());
  list.mesh.vertices.insert(list.mesh.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
  for (const uint32_t index : mesh.indices) list.mesh.indices.push_back(base + index);
  return run;
}

void AppendRange(const Tessellation& part, int texture, DrawList& list) {
  DrawRange range;
  range.texture = texture;
  for (const Vertex& vertex : part.fine.vertices) {
    range.bounds.extend(Eigen::Vector3f(vertex.position));
  }
  range.fine = AppendMesh(part.fine, list);
  range.coarse = AppendMesh(part.coarse, list);
  list.ranges.push_back(range);
}

/// A range a texture.
DrawList ListOf(const std::map<int, Tessellation>& parts) {
  DrawList list;
  for (const auto& [texture, part] : parts) AppendRange(part, texture, list);
  return list;
}

/// Flat ground takes shadows but throws none; leaving it out saves filling the whole shadow map.
bool IsFlatGround(const DrawRange& range) { return range.bounds.max().z() < 0.03F; }

/// Nor do hills and woods round a module: what is shaded is near.
bool IsLandscape(const DrawRange& range) {
  return range.bounds.sizes().head<2>().norm() > kLandscape;
}

int TextureOf(const Visual& visual, const std::filesystem::path& file) {
  try {
    return SurfaceTextureIndex(visual.material.texture);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", file.string(), error.what()));
  }
}

}  // namespace

DrawList BuildWorldDrawList(const ModuleModel& module) {
  std::map<std::tuple<int, int, int, bool>, Tessellation> parts;
  for (const WorldObject& object : module.objects) {
    for (const Visual& visual : object.visuals) {
      const Eigen::Vector3d centre = object.X_MO * visual.X_OV.translation();
      const auto cell = [](double coordinate) {
        return static_cast<int>(std::floor(coordinate / kCell));
      };
      Tessellation& part = parts[{TextureOf(visual, object.name), cell(centre.x()),
                                  cell(centre.y()), visual.casts_shadow}];
      AppendVisual(visual, object.X_MO, 0, kFineWorld, part.fine);
      AppendVisual(visual, object.X_MO, 0, kCoarseWorld, part.coarse);
    }
  }
  DrawList list;
  for (const auto& [key, part] : parts) {
    AppendRange(part, std::get<0>(key), list);
    DrawRange& range = list.ranges.back();
    range.casts_shadow = std::get<3>(key) && !IsFlatGround(range) && !IsLandscape(range);
  }
  return list;
}

DrawList BuildMovablesDrawList(const ModuleModel& module) {
  const Eigen::Isometry3d X_OO = Eigen::Isometry3d::Identity();
  std::map<int, Tessellation> parts;
  for (size_t i = 0; i < module.movables.size(); ++i) {
    for (const Visual& visual : module.movables[i].visuals) {
      Tessellation& part = parts[TextureOf(visual, module.movables[i].name)];
      AppendVisual(visual, X_OO, static_cast<int>(i), kFineThing, part.fine);
      AppendVisual(visual, X_OO, static_cast<int>(i), kCoarseThing, part.coarse);
    }
  }
  return ListOf(parts);
}

DrawList BuildRobotDrawList(const RobotModel& robot) {
  const Eigen::Isometry3d X_LL = Eigen::Isometry3d::Identity();
  std::map<int, Tessellation> parts;
  for (const LinkVisual& link_visual : robot.visuals) {
    Tessellation& part = parts[TextureOf(link_visual.visual, robot.file)];
    const int bone = 1 + link_visual.link;
    AppendVisual(link_visual.visual, X_LL, bone, kFineThing, part.fine);
    AppendVisual(link_visual.visual, X_LL, bone, kCoarseThing, part.coarse);
  }
  return ListOf(parts);
}

}  // namespace eod::sim
