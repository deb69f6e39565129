#pragma once

#include "sim/camera/surface_mesh.h"

namespace eod::sim {

/// Meadow around the module, out to where fog hides it: rings around the camera's own place.
SurfaceMesh MakeSurroundings();
inline constexpr int kSurroundingsTriangles = 16 * (1 + 2 + 2);

}  // namespace eod::sim
