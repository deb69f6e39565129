#include "sim/camera/rain_streaks.h"

#include <algorithm>
#include <cmath>

#include "sim/camera/noise.h"

namespace eod::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;
using Eigen::Vector4d;

constexpr double kBox = 14;                     // [m] a side of the air that drops are drawn in
constexpr double kMostDrops = 1500;             // in it, at a cloudburst of ...
constexpr double kCloudburst = 50;              // [mm/h]
constexpr double kExposure = 1.0 / 50;          // [s]
constexpr double kWidth = 0.0045;               // [m] of a streak: a drop and the blur around it
constexpr double kThinnest = 1.3;               // [px]
constexpr double kNearest = 0.35;               // [m]
constexpr float kClearest = 0.42F;              // opacity of a streak as wide as it is drawn
constexpr double kWindX = 0.10, kWindY = 0.06;  // of the speed of fall

double FallSpeed(double rain) {
  const double diameter_mm = 1.24 * std::pow(rain, 0.182);
  return std::max(9.65 - 10.3 * std::exp(-0.6 * diameter_mm), 2.0);
}

/// Into -half..half of the box.
double Wrapped(double value) { return value - kBox * std::floor(value / kBox + 0.5); }

/// Light of spots on a drop, which throws it back to all sides.
float SpotLight(const Vector3f& p_M, std::span<const ShiningSpot> spots) {
  float sum = 0;
  for (const ShiningSpot& spot : spots) {
    const Vector3f ray = p_M - spot.p_M;
    const float distance = ray.norm();
    const float cone = std::clamp((ray.dot(spot.direction) / distance - spot.dark_cosine) /
                                      (spot.bright_cosine - spot.dark_cosine),
                                  0.0F, 1.0F);
    sum += cone * static_cast<float>(spot.light.falloff.At(static_cast<double>(distance))) *
           spot.light.colour.mean();
  }
  return sum;
}

struct Corner {
  Vector2d px;
  double depth;
};

/// Where it is in the picture, from its middle [px], and its depth, -1..1.
Corner Project(const Vector4d& clip, const RainScene& scene) {
  return {{clip.x() / clip.w() * scene.width / 2, clip.y() / clip.w() * scene.height / 2},
          clip.z() / clip.w()};
}

void AppendStreak(const Corner& low, const Corner& high, double width, const Vector3f& colour,
                  float alpha, const RainScene& scene, std::vector<ColourVertex>& triangles) {
  const Vector2d along = high.px - low.px;
  const Vector2d across =
      Vector2d(-along.y(), along.x()) * (width / 2 / std::max(along.norm(), 1e-6));
  const auto to_byte = [](float value) {
    return static_cast<uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F));
  };
  const auto corner = [&](const Corner& at, double side) {
    const Vector2d px = at.px + side * across;
    return ColourVertex{
        {static_cast<float>(px.x() * 2 / scene.width),
         static_cast<float>(px.y() * 2 / scene.height), static_cast<float>(at.depth)},
        {to_byte(colour.x()), to_byte(colour.y()), to_byte(colour.z()), to_byte(alpha)}};
  };
  for (const auto& [at, side] : {std::pair(&low, -1.0),
                                 {&low, 1.0},
                                 {&high, 1.0},
                                 {&low, -1.0},
                                 {&high, 1.0},
                                 {&high, -1.0}}) {
    triangles.push_back(corner(*at, side));
  }
}

}  // namespace

void AppendRain(const RainScene& scene, const View& view, const Lighting& lighting,
                std::span<const ShiningSpot> spots, LightProbe* probe,
                std::vector<ColourVertex>& triangles) {
  if (scene.rain <= 0) return;
  const auto count =
      static_cast<int>(kMostDrops * std::sqrt(std::min(scene.rain, kCloudburst) / kCloudburst));
  const double speed = FallSpeed(scene.rain);
  const Vector3d velocity(kWindX * speed, kWindY * speed, -speed);
  std::vector<Vector3f> drops;
  for (int i = 0; i < count; ++i) {
    Vector3d place;
    for (int axis = 0; axis < 3; ++axis) {
      const double start = kBox * static_cast<double>(LatticeValue(i, axis, scene.seed));
      place[axis] =
          view.p_ME[axis] + Wrapped(start + velocity[axis] * scene.time_s - view.p_ME[axis]);
    }
    const Vector4d clip = view.clip * place.homogeneous();
    // A streak is short: what is well out of sight at its lower end is so at the other.
    if (clip.w() < kNearest || std::abs(clip.x()) > 1.3 * clip.w() ||
        std::abs(clip.y()) > 1.6 * clip.w()) {
      continue;
    }
    drops.push_back(place.cast<float>());
  }
  std::vector<bool> roofed(drops.size());
  if (probe != nullptr) probe->Roofed(drops, roofed);
  // Drops throw back the sky from all around, so they are somewhat brighter than the air.
  const Vector3f air = 1.12F * lighting.fog_colour + Vector3f::Constant(0.02F);
  for (size_t i = 0; i < drops.size(); ++i) {
    if (roofed[i]) continue;
    const Vector3d low = drops[i].cast<double>();
    const Vector4d clip = view.clip * low.homogeneous();
    const Vector4d upper = view.clip * (low - kExposure * velocity).homogeneous();
    if (upper.w() < kNearest) continue;
    const double seen_width = kWidth * scene.focal_px / clip.w();
    const double width = std::max(seen_width, kThinnest);
    const auto alpha = kClearest * static_cast<float>(seen_width / width);
    const float lit = 0.25F * SpotLight(drops[i], spots);
    const Vector3f colour = (air.cwiseAbs2() + Vector3f::Constant(lit)).cwiseSqrt();
    AppendStreak(Project(clip, scene), Project(upper, scene), width, colour, alpha, scene,
                 triangles);
  }
}

}  // namespace eod::sim
