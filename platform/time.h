#pragma once

#include <chrono>
#include <cstdint>

namespace eod {

/// Length of time. Resolution 1 ns.
using Duration = std::chrono::nanoseconds;

/// Moment on the one time base of the product: Unix time, counted by a clock that never steps back.
/// In lock-step it starts at the epoch (0).
using TimePoint = std::chrono::sys_time<std::chrono::nanoseconds>;

/// Microseconds since 1970, as every `utime` field carries them.
inline int64_t ToUtime(TimePoint time) {
  return std::chrono::duration_cast<std::chrono::microseconds>(time.time_since_epoch()).count();
}

inline TimePoint FromUtime(int64_t utime_us) {
  return TimePoint{std::chrono::microseconds{utime_us}};
}

inline double ToSeconds(Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace eod
