#pragma once

#include <span>
#include <vector>

#include "sim/camera/camera_thread.h"
#include "sim/camera/gpu_mesh.h"
#include "sim/camera/view.h"

namespace eod::sim {

/// Colours of isector lines, RGBA.
inline constexpr uint8_t kFreeColour[4] = {60, 210, 255, 255};
inline constexpr uint8_t kHitColour[4] = {255, 210, 40, 255};
inline constexpr uint8_t kContactColour[4] = {255, 30, 30, 255};

/// Turns segments into ribbons of constant width on the screen, each as far as its hit, which gets
/// a cross. Appends to `triangles` in clip space (w = 1); what lies behind the camera is cut off.
void AppendSegments(std::span<const DrawnSegment> segments, const View& view, int width, int height,
                    std::vector<ColourVertex>& triangles);

}  // namespace eod::sim
