#pragma once

#include <cstdint>
#include <random>

#include <Eigen/Core>

#include "sim/geometry/mesh.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// Numbers that are the same with every standard library: distributions of <random> are not.
class SeededNumbers {
 public:
  explicit SeededNumbers(uint64_t seed) : engine_(seed) {}
  double Between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  size_t Below(size_t count) { return static_cast<size_t>(engine_() % count); }
  Eigen::Vector3d InBox(double half) {
    return {Between(-half, half), Between(-half, half), Between(-half, half)};
  }

 private:
  std::mt19937_64 engine_;
};

/// Adds the triangles of `mesh`, moved by `shift`, as a new object.
inline void AddObject(ModuleModel& module, const std::string& name, uint32_t class_mask, Mesh mesh,
                      const Eigen::Vector3d& shift = Eigen::Vector3d::Zero()) {
  const int object = static_cast<int>(module.objects.size());
  module.objects.push_back({.name = name, .visuals = {}});
  for (Triangle& triangle : mesh) {
    for (Eigen::Vector3d& corner : triangle) corner += shift;
    module.triangles.push_back({triangle, class_mask, object});
  }
}

/// Boxes, round things and loose triangles over a grid of ground in a cube of 40 m.
inline ModuleModel RandomScene(uint64_t seed) {
  SeededNumbers numbers(seed);
  ModuleModel module;
  AddObject(module, "ground", kModuleFlat | kClampProxy | kBumpProxy, PlaneMesh(40, 40, 2));
  for (int i = 0; i < 36; ++i) {
    const uint32_t proxy = numbers.Below(2) == 0 ? kBumpProxy : kBumpProxy | kClampProxy;
    const double size = numbers.Between(0.05, 2);
    Mesh mesh = i % 3 == 0   ? BoxMesh(Eigen::Vector3d(size, 1, 0.5))
                : i % 3 == 1 ? CylinderMesh(size / 2, 1, 24)
                             : SphereMesh(size / 2, 6, 12);
    AddObject(module, "thing", kModuleFlat | proxy, std::move(mesh), numbers.InBox(18));
  }
  Mesh loose;
  for (int i = 0; i < 400; ++i) {
    const Eigen::Vector3d corner = numbers.InBox(19);
    loose.push_back({corner, corner + numbers.InBox(1), corner + numbers.InBox(1)});
  }
  AddObject(module, "loose", kModuleFlat | kBumpProxy, std::move(loose));
  return module;
}

}  // namespace eod::sim
