#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "sim/camera/gpu_mesh.h"
#include "sim/camera/light_probe.h"
#include "sim/camera/lighting.h"
#include "sim/camera/spot_lights.h"
#include "sim/camera/view.h"

namespace eod::sim {

/// A moment of rain before a camera.
struct RainScene {
  double rain = 0;        ///< [mm/h]
  double time_s = 0;      ///< drops fall with it
  uint32_t seed = 0;      ///< of where they are
  int width = 640;        ///< of the picture [px]
  int height = 480;       ///< [px]
  double focal_px = 400;  ///< [px] a radian in the middle of the picture
};

/// Drops as streaks in the air around the camera, in the module's local frame: they fall as fast as
/// drops of that rain do, at D0 = 1.24 R^0.182 [mm] (Marshall and Palmer 1948) v = 9.65 - 10.3
/// exp(-0.6 D0) [m/s] (Atlas et al. 1973), for the 1/50 s that a picture is exposed. The air that
/// they are in moves with the camera by whole boxes, so a drop stays where it is when it drives on.
/// Adds two triangles a streak to `triangles`, in normalised device coordinates. None falls under a
/// roof. Headlights light the drops.
void AppendRain(const RainScene& scene, const View& view, const Lighting& lighting,
                std::span<const ShiningSpot> spots, LightProbe* probe,
                std::vector<ColourVertex>& triangles);

}  // namespace eod::sim
