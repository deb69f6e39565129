#include "sim/camera/lighting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eod::sim {
namespace {

using Eigen::Vector3f;

constexpr float kSunStrength = 1.45F;
constexpr float kSkyStrength = 0.62F;
constexpr float kDuskElevation = 0.12F;  // [rad] 7 degrees
constexpr double kHidesHills = 1000;     // [m] of visibility: nothing far away is seen, ...
constexpr double kHidesNothing = 5000;   // [m] ... and all is

Vector3f Grey(float value) { return Vector3f::Constant(value); }

Vector3f Mix(const Vector3f& a, const Vector3f& b, float share) { return a + (b - a) * share; }

/// As far west as the day's sun is east.
Vector3f DuskSun(const Vector3f& to_sun) {
  Vector3f level(-to_sun.x(), to_sun.y(), 0);
  level = level.norm() < 1e-3F ? Vector3f(-Vector3f::UnitX()) : level.normalized();
  return std::cos(kDuskElevation) * level + std::sin(kDuskElevation) * Vector3f::UnitZ();
}

Lighting ClearDay(const Atmosphere& air) {
  Lighting light;
  light.to_sun = air.sun_direction.normalized();
  light.sun_light = air.sun_colour * kSunStrength;
  // Light from above is the sky's own colour paled by clouds; from below, what grass gives back.
  light.sky_light = (0.5F * air.sky_colour + Grey(0.34F)) * kSkyStrength;
  light.ground_light = Vector3f(0.20F, 0.20F, 0.15F);
  light.fog_colour = air.fog_colour;
  light.sky.disc = Vector3f(1.0F, 0.99F, 0.95F);
  light.sky.glow = 0.16F * air.sun_colour;
  light.sky.zenith = air.sky_colour;
  light.sky.cloud_lit = Vector3f(1.0F, 0.99F, 0.97F);
  light.sky.cloud_shade = Vector3f(0.58F, 0.62F, 0.68F);
  return light;
}

Lighting ClearDusk(const Atmosphere& air) {
  Lighting light;
  light.to_sun = DuskSun(air.sun_direction.normalized());
  light.sun_light = Vector3f(0.62F, 0.31F, 0.13F);
  light.sky_light = Vector3f(0.145F, 0.150F, 0.205F);
  light.ground_light = Vector3f(0.055F, 0.050F, 0.045F);
  light.fog_colour = Vector3f(0.56F, 0.47F, 0.45F);
  light.street_lamps = true;
  light.sky.disc = Vector3f(1.0F, 0.80F, 0.50F);
  light.sky.glow = Vector3f(0.42F, 0.20F, 0.03F);
  light.sky.zenith = Vector3f(0.20F, 0.26F, 0.42F);
  light.sky.cloud_lit = Vector3f(0.86F, 0.56F, 0.44F);
  light.sky.cloud_shade = Vector3f(0.33F, 0.31F, 0.40F);
  light.sky.hills = 0.5F;
  return light;
}

Lighting ClearNight(const Atmosphere& air) {
  Lighting light;
  const Vector3f sun = air.sun_direction.normalized();
  light.to_sun = Vector3f(-sun.x(), -sun.y(), std::max(sun.z(), 0.3F)).normalized();
  light.sun_light = Vector3f(0.0085F, 0.0100F, 0.0135F);
  light.sky_light = Vector3f(0.0050F, 0.0062F, 0.0090F);
  light.ground_light = Grey(0.0020F);
  light.fog_colour = Vector3f(0.055F, 0.064F, 0.085F);
  light.street_lamps = true;
  light.sky.disc = Vector3f(0.80F, 0.82F, 0.80F);
  light.sky.glow = Vector3f(0.030F, 0.034F, 0.042F);
  light.sky.zenith = Vector3f(0.016F, 0.022F, 0.042F);
  light.sky.cloud_lit = Vector3f(0.085F, 0.092F, 0.110F);
  light.sky.cloud_shade = Vector3f(0.040F, 0.045F, 0.060F);
  light.sky.hills = 0.07F;
  light.sky.stars = 0.55F;
  return light;
}

Lighting Clear(const Atmosphere& air, Weather::Light hour) {
  switch (hour) {
    case Weather::Light::kDay:
      return ClearDay(air);
    case Weather::Light::kDusk:
      return ClearDusk(air);
    case Weather::Light::kNight:
      break;
  }
  return ClearNight(air);
}

/// What a closed cover of cloud leaves: even light from above, and the colour of the air.
struct Grizzle {
  Vector3f light;
  Vector3f air;
};

Grizzle Overcast(Weather::Light hour) {
  switch (hour) {
    case Weather::Light::kDay:
      return {Vector3f(0.60F, 0.62F, 0.65F), Vector3f(0.68F, 0.70F, 0.72F)};
    case Weather::Light::kDusk:
      return {Vector3f(0.105F, 0.110F, 0.130F), Vector3f(0.34F, 0.345F, 0.38F)};
    case Weather::Light::kNight:
      break;
  }
  return {Vector3f(0.0045F, 0.0048F, 0.0056F), Vector3f(0.048F, 0.052F, 0.060F)};
}

float Share(double share) { return static_cast<float>(std::clamp(share, 0.0, 1.0)); }

}  // namespace

Lighting LightingOf(const Atmosphere& air, const Weather& weather) {
  constexpr double kContrast = 20;                        // 1 / 5 %
  constexpr double kPerMetre = std::numbers::ln10 / 1e4;  // of 1 dB/km
  Lighting light = Clear(air, weather.light);
  const bool is_hazy = weather.visibility > 0;
  light.fog_density =
      is_hazy
          ? static_cast<float>(std::log(kContrast) / weather.visibility)
          : air.fog_density + static_cast<float>(1.076 * kPerMetre * std::pow(weather.rain, 0.67));
  light.sky.haze =
      is_hazy ? Share((kHidesNothing - weather.visibility) / (kHidesNothing - kHidesHills)) : 0;
  const float rain = 1 - static_cast<float>(std::exp(-weather.rain));
  light.wetness = rain;
  light.sky.haze = std::max(light.sky.haze, 0.5F * rain);
  const float overcast = std::max(rain, is_hazy ? light.sky.haze : 0);
  const Grizzle grizzle = Overcast(weather.light);
  light.sun_light *= (1 - overcast) * (1 - overcast);
  light.sky_light = Mix(light.sky_light, grizzle.light, overcast);
  light.ground_light = Mix(light.ground_light, 0.28F * grizzle.light, overcast);
  light.fog_colour = Mix(light.fog_colour, grizzle.air, overcast);
  light.sky.overcast = overcast;
  light.sky.stars *= 1 - overcast;
  light.sky.horizon = light.fog_colour;
  light.sky.zenith = Mix(light.sky.zenith, 0.9F * grizzle.air, overcast);
  light.sky.to_light = light.to_sun;
  return light;
}

}  // namespace eod::sim
