#include "sim/camera/surroundings.h"

#include <array>
#include <cmath>
#include <numbers>

namespace eod::sim {

SurfaceMesh MakeSurroundings() {
  constexpr std::array kRadii{40.0, 200.0, 2500.0};
  constexpr int kSides = 16;
  Visual meadow;
  meadow.shape = Visual::Shape::kMesh;
  meadow.material.diffuse = Eigen::Vector3f::Ones();
  const auto rim = [](double radius, int side) {
    const double angle = 2 * std::numbers::pi * side / kSides;
    return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0)
        .cast<float>()
        .eval();
  };
  double inner = 0;
  for (const double outer : kRadii) {
    for (int side = 0; side < kSides; ++side) {
      const std::array corners{rim(inner, side), rim(outer, side), rim(outer, side + 1),
                               rim(inner, side + 1)};
      for (const size_t corner : {0, 1, 2, 0, 2, 3}) meadow.triangles.push_back(corners[corner]);
    }
    inner = outer;
  }
  SurfaceMesh mesh;
  AppendVisual(meadow, Eigen::Isometry3d::Identity(), 0, {}, mesh);
  return mesh;
}

}  // namespace eod::sim
