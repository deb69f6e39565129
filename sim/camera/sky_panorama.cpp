#include "sim/camera/sky_panorama.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "sim/camera/noise.h"

namespace eod::sim {
namespace {

using Eigen::Vector3f;
using Colour = Eigen::Vector3f;

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kLowest = -3.0F * kPi / 180.0F;
constexpr float kHighest = 90.0F * kPi / 180.0F;
constexpr float kHighestLand = 7.0F * kPi / 180.0F;

float SmoothStep(float low, float high, float value) {
  const float t = std::clamp((value - low) / (high - low), 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

Colour Mix(const Colour& a, const Colour& b, float share) { return a + (b - a) * share; }

/// Clouds lie on a plane high above: thickness there, 0..1, and how much sunlight is on them.
struct Cloud {
  float cover;
  float light;
};

float CloudDensity(float x, float y, int octaves) {
  const float shape = TilingFbm(x * 0.55F + 32, y * 0.55F + 32, 64, octaves, 201);
  const float field = TilingNoise(x * 0.15F + 32, y * 0.15F + 32, 64, 202);
  return shape + 0.34F * (field - 0.5F);
}

Cloud CloudAt(const Vector3f& direction, const Vector3f& to_sun) {
  // The plane bends down with the distance, else clouds shrink to lines at the horizon.
  const float scale = 1.7F / (direction.z() + 0.16F);
  const float x = direction.x() * scale;
  const float y = direction.y() * scale;
  const float density = CloudDensity(x, y, 6);
  const float cover = SmoothStep(0.50F, 0.72F, density);
  if (cover == 0.0F) return {0, 0};
  const float sunward = CloudDensity(x + 0.16F * to_sun.x(), y + 0.16F * to_sun.y(), 3);
  return {cover,
          std::clamp(0.78F + 1.6F * (density - sunward) - 0.55F * (density - 0.55F), 0.0F, 1.0F)};
}

/// Height of a ridge line above the horizon [rad] along the circle, u 0..1.
float Ridge(float u, int period, float low, float high, uint32_t seed) {
  const float scale = static_cast<float>(period);
  const float level = TilingFbm(u * scale, 0.5F, period, 6, seed);
  return (low + (high - low) * level) * kPi / 180.0F;
}

/// Tops of trees: round crowns and spires of several sizes on a slow swell.
float TreeTop(float u) {
  const float swell = TilingNoise(u * 24.0F, 0.5F, 24, 301);
  const float crown = TilingNoise(u * 300.0F, 0.5F, 300, 302);
  const float twig = TilingNoise(u * 1500.0F, 0.5F, 1500, 303);
  const float clearing = SmoothStep(0.22F, 0.45F, TilingNoise(u * 11.0F, 0.5F, 11, 304));
  const float degrees = (0.35F + 1.0F * swell + 0.75F * crown * crown + 0.22F * twig) * clearing;
  return degrees * kPi / 180.0F;
}

/// Heights above the horizon [rad] of what stands there, in one direction.
struct Skyline {
  float far_hills;
  float near_hills;
  float trees;
};

Skyline SkylineAt(float u) {
  return {Ridge(u, 5, 0.2F, 6.4F, 311), Ridge(u, 9, -0.6F, 4.2F, 312), TreeTop(u)};
}

struct Painter {
  const SkyLook& look;
  Colour fog;

  Colour Sky(const Vector3f& direction) const {
    const float up = std::max(direction.z(), 0.0F);
    Colour colour = Mix(fog, look.zenith, 1.0F - std::exp(-3.2F * up));
    const float clear = 1 - look.overcast;
    if (clear == 0) return colour;
    const float low = SmoothStep(0.01F, 0.22F, up);
    const Cloud cloud = low > 0 ? CloudAt(direction, look.to_light) : Cloud{0, 0};
    const Colour white = Mix(look.cloud_shade, look.cloud_lit, cloud.light);
    colour = Mix(colour, white, 0.9F * clear * cloud.cover * low);
    const float towards = std::max(direction.dot(look.to_light), 0.0F);
    colour += clear * look.glow * (std::pow(towards, 12.0F) + 2.2F * std::pow(towards, 160.0F));
    // Disc of three degrees: a camera's bloom makes it larger than it is.
    return Mix(colour, look.disc, clear * SmoothStep(0.99935F, 0.9997F, towards));
  }

  /// `sky` with the hills and trees that stand before it.
  Colour Land(Colour sky, const Skyline& line, float u, float elevation) const {
    constexpr float kSoftness = 0.0012F;  // [rad] a pixel
    const auto cover = [&](const Colour& with, float top) {
      sky = Mix(sky, with, 1.0F - SmoothStep(top - kSoftness, top + kSoftness, elevation));
    };
    cover(Mix(fog, look.hills * Colour(0.48F, 0.57F, 0.68F), 0.50F), line.far_hills);
    cover(Mix(fog, look.hills * Colour(0.42F, 0.53F, 0.53F), 0.70F), line.near_hills);
    const float leaf = TilingNoise(u * 1800.0F, elevation * 300.0F, 1800, 313);
    cover(Mix(fog, look.hills * Colour(0.30F, 0.38F, 0.25F) * (0.85F + 0.3F * leaf), 0.78F),
          line.trees);
    // Mist at the foot of the trees joins them with the fogged ground.
    return Mix(sky, fog, 0.85F * (1.0F - SmoothStep(-0.003F, 0.006F, elevation)));
  }

  Colour At(float u, float elevation, const Skyline& line) const {
    const float azimuth = 2 * kPi * u;
    const Vector3f direction(std::sin(azimuth) * std::cos(elevation),
                             std::cos(azimuth) * std::cos(elevation), std::sin(elevation));
    const Colour sky = Sky(direction);
    const Colour all = elevation < kHighestLand ? Land(sky, line, u, elevation) : sky;
    return Mix(all, fog, look.haze);
  }
};

/// Dots above the land, more of them the fainter they are. Evenly over the sky: the sine of the
/// elevation is uniform.
void PaintStars(float brightness, Canvas& canvas) {
  constexpr int kStars = 1400;
  PaintRandom random(77);
  for (int star = 0; star < kStars; ++star) {
    const float u = random.Uniform(0, 1);
    const float elevation = std::asin(random.Uniform(std::sin(kHighestLand), 1));
    const float magnitude = random.Uniform(0, 1);
    const auto x = static_cast<int>(u * static_cast<float>(canvas.width()));
    const auto y = static_cast<int>(PanoramaRow(elevation) * static_cast<float>(canvas.height()));
    canvas.At(x, std::min(y, canvas.height() - 1)) +=
        Colour::Constant(brightness * magnitude * magnitude * magnitude);
  }
}

}  // namespace

float PanoramaElevation(float v) { return kLowest + (kHighest - kLowest) * v * v; }

float PanoramaRow(float elevation) {
  return std::sqrt(std::clamp((elevation - kLowest) / (kHighest - kLowest), 0.0F, 1.0F));
}

Image PaintSkyPanorama(const SkyLook& look, int width, int height) {
  const Painter painter{look, look.horizon};
  std::vector<Skyline> skyline;
  skyline.reserve(static_cast<size_t>(width));
  for (int x = 0; x < width; ++x) {
    skyline.push_back(SkylineAt((static_cast<float>(x) + 0.5F) / static_cast<float>(width)));
  }
  Canvas canvas(width, height);
  canvas.Fill([&](float u, float v) {
    const auto column = static_cast<size_t>(u * static_cast<float>(width));
    return painter.At(u, PanoramaElevation(v), skyline.at(column));
  });
  if (look.stars > 0) PaintStars(look.stars * (1 - look.haze), canvas);
  return canvas.ToImage();
}

}  // namespace eod::sim
