#pragma once

#include <span>
#include <vector>

#include "sim/camera/canvas.h"
#include "sim/camera/gl_object.h"
#include "sim/camera/plume_quads.h"

namespace eod::sim {

/// Paints the one texture of all plumes, 64 x 64: alpha falls off radially under value noise to
/// nothing at the rim, red, green and blue are the same lumps of light and shade.
Image PaintPuff();

/// Draws plumes over the scene: depth is tested and not written.
class PlumePass {
 public:
  explicit PlumePass(const GlFunctions& gl);

  /// Returns the number of triangles. Leaves blending off and depth writing on.
  int Draw(std::span<const PlumeQuad> quads, const Eigen::Isometry3d& X_MC, const Lens& lens);

 private:
  const GlFunctions* gl_;
  GlObject program_;
  GlObject texture_;
  GlObject array_;
  GlObject buffer_;
  std::vector<PlumeVertex> vertices_;
};

}  // namespace eod::sim
