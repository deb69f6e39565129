#pragma once

#include <optional>

#include "sim/camera/gpu_mesh.h"
#include "sim/camera/lighting.h"
#include "sim/camera/view.h"

namespace eod::sim {

/// The painted panorama on a dome that moves with the camera, behind everything.
class SkyDome {
 public:
  explicit SkyDome(const GlFunctions& gl);

  /// Paints the panorama unless it looks like that already. Needed before the first Draw.
  void SetLook(const SkyLook& look);

  /// Draws where nothing nearer was drawn. Returns the triangles given to OpenGL.
  int Draw(const View& view, bool is_infrared) const;

 private:
  const GlFunctions* gl_;
  GlObject program_;
  GLint view_projection_;
  GLint grey_;
  std::optional<SkyLook> look_;  ///< of the texture
  std::optional<GlObject> texture_;
  SurfaceMesh dome_;
  GpuMesh mesh_;
};

}  // namespace eod::sim
