#pragma once

#include "sim/camera/canvas.h"
#include "sim/camera/lighting.h"

namespace eod::sim {

/// Elevation above the horizon [rad] of a row of the panorama, `v` 0 (bottom) .. 1 (zenith). Rows
/// lie close together near the horizon, where hills and trees need them. From -3 to 90 degrees.
float PanoramaElevation(float v);

/// Inverse of PanoramaElevation.
float PanoramaRow(float elevation);

/// Paints all that is too far away to move with the camera: sky gradient, sun, clouds, hills and a
/// line of trees. Column u is the direction (sin 2 pi u, cos 2 pi u) in X, Y.
Image PaintSkyPanorama(const SkyLook& look, int width, int height);

}  // namespace eod::sim
