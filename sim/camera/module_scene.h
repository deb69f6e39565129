#pragma once

#include <span>
#include <vector>

#include "sim/camera/camera_thread.h"
#include "sim/camera/draw_list.h"
#include "sim/camera/gpu_mesh.h"
#include "sim/camera/light_probe.h"
#include "sim/camera/surface_program.h"

namespace eod::sim {

/// A module as it is drawn: its shapes in OpenGL's memory, the light of its lamps and the shade of
/// its roofs written into them.
class ModuleScene {
 public:
  /// `model` must outlive it. Throws std::runtime_error for an unknown texture.
  ModuleScene(const GlFunctions& gl, const ModuleModel& model, bool street_lamps);

  /// Moves the movable objects; those that are not told stand where they start.
  void Pose(std::span<const DrawnMovable> movables);

  const DrawList& list() const { return list_; }  ///< without its mesh
  const GpuMesh& mesh() const { return mesh_; }
  const DrawList& movables_list() const { return movables_list_; }
  const GpuMesh& movables_mesh() const { return movables_mesh_; }
  const BonePalette& movables_bones() const { return movables_bones_; }
  LightProbe& probe() { return probe_; }

 private:
  const ModuleModel& model_;
  LightProbe probe_;
  DrawList list_;
  GpuMesh mesh_;
  DrawList movables_list_;
  GpuMesh movables_mesh_;
  BonePalette movables_bones_;
};

}  // namespace eod::sim
