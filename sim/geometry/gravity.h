#pragma once

namespace eod::sim {

/// Standard gravity [m/s^2].
inline constexpr double kGravity = 9.80665;

}  // namespace eod::sim
