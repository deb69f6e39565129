#pragma once

#include "sim/camera/gpu_mesh.h"
#include "sim/camera/view.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// The painted panorama on a dome that moves with the camera, behind everything.
class SkyDome {
 public:
  SkyDome(const GlFunctions& gl, const Atmosphere& atmosphere);

  /// Draws where nothing nearer was drawn. Returns the triangles given to OpenGL.
  int Draw(const View& view) const;

 private:
  const GlFunctions* gl_;
  GlObject program_;
  GLint view_projection_;
  GlObject texture_;
  SurfaceMesh dome_;
  GpuMesh mesh_;
};

}  // namespace eod::sim
