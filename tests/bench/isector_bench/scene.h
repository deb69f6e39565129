#pragma once

#include <cstdint>

#include "sim/world/world_model.h"

namespace eod::bench {

/// What every triangle of a scene is; TRIPOD, BUMP and LOS meet all of it, so that engines without
/// class masks have the same task.
inline constexpr uint32_t kSceneClass = sim::kModuleOutdoor | sim::kClampProxy | sim::kBumpProxy;

/// An outdoor module of N triangles: rolling terrain as a grid of PlaneMesh, the site of
/// SiteObjects, and boxes and buildings at random round it (a twentieth of the triangles).
///
/// Of each factor of ten in N a factor of five goes into area and two into density, as with a
/// survey that covers more ground and looks closer: 8 triangles a m2 at 1e4 (cells of 0.5 m), 16,
/// 32, and 64 at 1e7 (cells of 0.18 m, area 385 m x 385 m). The density near the path is that of
/// the terrain plus that of the site, see DensityNearPath.
struct Scene {
  sim::ModuleModel module;
  double terrain_density = 0;                              ///< triangles of terrain a m2
  Eigen::Vector2d terrain_size = Eigen::Vector2d::Zero();  ///< [m]
};

/// Exactly so many triangles; the same bits for the same number. `triangles` is 10000 or more;
/// throws std::invalid_argument.
Scene MakeScene(int64_t triangles);

/// Triangles a m2 of plan within 1.5 m of the robot's path: terrain, walls, stairs and all.
double DensityNearPath(const Scene& scene);

}  // namespace eod::bench
