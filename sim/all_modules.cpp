#include "sim/all_modules.h"

namespace eod::sim {
namespace {

void Append(const ModuleModel& other, const Eigen::Vector3d& shift, ModuleModel& all) {
  const int first = static_cast<int>(all.objects.size());
  for (const WorldObject& object : other.objects) {
    all.objects.push_back(
        {.name = object.name, .X_MO = Eigen::Translation3d(shift) * object.X_MO, .visuals = {}});
  }
  for (CollisionTriangle triangle : other.triangles) {
    for (Eigen::Vector3d& corner : triangle.corner) corner += shift;
    triangle.object += first;
    all.triangles.push_back(triangle);
  }
}

}  // namespace

ModuleModel WithAllModules(const WorldModel& world, const ModuleModel& own) {
  ModuleModel all = own;
  for (const ModuleModel& other : world.modules) {
    if (other.id != own.id) Append(other, other.p_WM - own.p_WM, all);
  }
  return all;
}

}  // namespace eod::sim
