#pragma once

#include <cstdint>

namespace eod::sim {

/// Light and air of an exercise.
struct Weather {
  enum class Light : uint8_t { kDay, kDusk, kNight };
  Light light = Light::kDay;
  double visibility = 0;  ///< [m] where 5 % of the contrast are left; 0: as the world's file says
  double rain = 0;        ///< [mm/h] 0 none, 2 light, 10 heavy, 50 a cloudburst
  bool operator==(const Weather&) const = default;
};

}  // namespace eod::sim
