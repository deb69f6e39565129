#include "tests/bench/isector_bench/scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "tests/bench/isector_bench/site.h"
#include "tests/unit/sim/random_scene.h"

namespace eod::bench {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int64_t kFewest = 10000;  // so that houses find room outside the site
constexpr size_t kBoxTriangles = 12;
constexpr double kModuleHalf = 1500;  // [m] the largest module that a world file may have

/// The terrain as a grid of cells; its triangles never outnumber what it was made for.
struct Grid {
  int columns, rows;
  Vector2d middle, size;

  Grid(int64_t triangles, double density) {
    const double cell = std::sqrt(2 / density);
    const auto cells = static_cast<double>(triangles / 2);
    columns = static_cast<int>(std::sqrt(cells));
    rows = static_cast<int>(cells / columns);
    size = Vector2d(columns, rows) * cell;
    // As far as it goes round the site, and never out of the module.
    middle = kSiteCentre.cwiseMin(Vector2d::Constant(kModuleHalf) - size / 2);
  }
};

void AddTerrain(const Grid& grid, sim::ModuleModel& module) {
  sim::Mesh mesh = sim::PlaneMesh(grid.size.x(), grid.size.y(), grid.size.x() / grid.columns);
  for (sim::Triangle& triangle : mesh) {
    for (Vector3d& corner : triangle) {
      corner.head<2>() += grid.middle;
      corner.z() = GroundHeight(corner.x(), corner.y());
    }
  }
  sim::AddObject(module, "terrain", kSceneClass, std::move(mesh));
}

/// One in ten is as large as a house, the others as a crate or a car.
sim::Mesh BoxSomewhere(const Grid& grid, sim::SeededNumbers& numbers) {
  const Isometry3d X_SM = SitePose().inverse();
  const bool house = numbers.Below(10) == 0;
  const double low = house ? 3 : 0.3, high = house ? 10 : 3;
  const Vector3d size(numbers.Between(low, high), numbers.Between(low, high),
                      numbers.Between(low, high));
  const double reach = size.head<2>().norm() / 2;
  const Vector2d half = grid.size / 2;
  Vector3d p_S;
  Isometry3d X_MO = Isometry3d::Identity();
  do {
    X_MO.translation().head<2>() = grid.middle + Vector2d(numbers.Between(-half.x(), half.x()),
                                                          numbers.Between(-half.y(), half.y()));
    p_S = X_SM * X_MO.translation();
  } while (std::abs(p_S.x()) < kSiteHalfU + reach && std::abs(p_S.y()) < kSiteHalfV + reach);
  X_MO.translation().z() = GroundHeight(X_MO.translation().x(), X_MO.translation().y());
  X_MO.rotate(Eigen::AngleAxisd(numbers.Between(0, std::numbers::pi), Vector3d::UnitZ()));
  return sim::Transformed(X_MO, sim::BoxMesh(size));
}

/// Boxes until there are `triangles`; the last one stays open where a whole one were too many.
void FillWithBoxes(const Grid& grid, size_t triangles, sim::ModuleModel& module) {
  sim::SeededNumbers numbers(10067311);
  while (module.triangles.size() < triangles) {
    sim::Mesh box = BoxSomewhere(grid, numbers);
    box.resize(std::min(kBoxTriangles, triangles - module.triangles.size()));
    sim::AddObject(module, "box", kSceneClass, std::move(box));
  }
}

}  // namespace

Scene MakeScene(int64_t triangles) {
  if (triangles < kFewest)
    throw std::invalid_argument(
        fmt::format("a scene of {} triangles: {} is the least", triangles, kFewest));
  Scene scene;
  scene.terrain_density = 8 * std::exp2(std::log10(static_cast<double>(triangles) / 1e4));
  sim::ModuleModel& module = scene.module;
  module.id = 4;
  module.name = "bench";
  module.class_bit = sim::kModuleOutdoor;
  module.half_size = Vector2d::Constant(kModuleHalf);
  module.triangles.reserve(static_cast<size_t>(triangles));
  for (SiteObject& object : SiteObjects())
    sim::AddObject(module, object.name, kSceneClass, std::move(object.mesh));
  const auto site = static_cast<int64_t>(module.triangles.size());
  const Grid grid(triangles - site - triangles / 20, scene.terrain_density);
  scene.terrain_size = grid.size;
  AddTerrain(grid, module);
  FillWithBoxes(grid, static_cast<size_t>(triangles), module);
  return scene;
}

double DensityNearPath(const Scene& scene) {
  constexpr double kAside = 1.5;
  constexpr double kArea =
      4 * (kLoopU + kAside) * (kLoopV + kAside) - 4 * (kLoopU - kAside) * (kLoopV - kAside);
  const Isometry3d X_SM = SitePose().inverse();
  int near = 0;
  for (const auto& [corner, mask, object] : scene.module.triangles) {
    const Vector3d p_S = X_SM * Vector3d((corner[0] + corner[1] + corner[2]) / 3);
    const double u = std::abs(p_S.x()), v = std::abs(p_S.y());
    const bool inside = u < kLoopU - kAside && v < kLoopV - kAside;
    if (u < kLoopU + kAside && v < kLoopV + kAside && !inside) ++near;
  }
  return near / kArea;
}

}  // namespace eod::bench
