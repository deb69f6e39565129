#pragma once

#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "sim/camera/view.h"
#include "sim/plume/plume_quad.h"

namespace eod::sim {

/// Fill rate rules by software rendering: no quad may cover more of the picture, nor all together.
inline constexpr double kMostOfAQuad = 0.15;
inline constexpr double kMostOfAllQuads = 3.0;

/// Corner of a plume's quad.
struct PlumeVertex {
  float position[4];  ///< clip space
  float uv[2];
  float colour[4];  ///< linear, and alpha
  float cover;      ///< 0: adds its light; 1: hides what is behind
};

/// Two triangles a quad towards the camera at `X_MC`, the farthest first; sizes are cut to the caps
/// above. What lies outside the picture is left out. `vertices` keeps its memory between calls.
void FaceCamera(std::span<const PlumeQuad> quads, const Eigen::Isometry3d& X_MC, const Lens& lens,
                std::vector<PlumeVertex>& vertices);

}  // namespace eod::sim
