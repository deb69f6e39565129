#include "sim/camera/module_scene.h"

#include "sim/camera/light_bake.h"

namespace eod::sim {
namespace {

DrawList BakedList(const ModuleModel& model, LightProbe& probe) {
  DrawList list = BuildWorldDrawList(model);
  BakeLight(probe, list);
  return list;
}

}  // namespace

ModuleScene::ModuleScene(const GlFunctions& gl, const ModuleModel& model, bool street_lamps)
    : model_(model),
      probe_(model, street_lamps),
      list_(BakedList(model, probe_)),
      mesh_(gl, list_.mesh),
      movables_list_(BuildMovablesDrawList(model)),
      movables_mesh_(gl, movables_list_.mesh),
      movables_bones_(MakePalette(model.movables.size())) {
  // Only the ranges are needed from here on.
  list_.mesh = {};
  movables_list_.mesh = {};
}

void ModuleScene::Pose(std::span<const DrawnMovable> movables) {
  for (size_t i = 0; i < model_.movables.size(); ++i) {
    const bool is_told = i < movables.size();
    if (is_told && !movables[i].is_visible) {
      HideBone(i, movables_bones_);
      continue;
    }
    const Eigen::Isometry3d& X_MO = is_told ? movables[i].X_MO : model_.movables[i].X_MO;
    SetBone(X_MO, i, movables_bones_);
    SetBoneLight(probe_.Around(X_MO.translation().cast<float>()), i, movables_bones_);
  }
}

}  // namespace eod::sim
