#pragma once

#include <array>
#include <string_view>

#include "sim/camera/canvas.h"

namespace eod::sim {

/// Names of the procedural textures, as materials use them (sim/geometry/visual.h).
inline constexpr std::array<std::string_view, 23> kSurfaceTextures{
    "plain",  "grass",   "concrete", "brick",  "asphalt",  "wood",    "metal",      "rubber",
    "hazard", "gravel",  "paving",   "render", "rooftile", "windows", "shopwindow", "fruit",
    "leaves", "plaster", "carpet",   "tile",   "ceiling",  "books",   "rack"};

/// Index in kSurfaceTextures. Throws std::runtime_error that names the textures there are.
int SurfaceTextureIndex(std::string_view name);

/// Paints one tile; the same bits in every run. Natural colours: a material's diffuse colour
/// multiplies them.
Image PaintSurfaceTexture(int index);

/// Slow variation of brightness and dryness over the ground: red and green are two different tiling
/// noises of mean 0.5.
Image PaintGroundVariation();

}  // namespace eod::sim
