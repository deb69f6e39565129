#include "platform/clock.h"

#include <chrono>

namespace eod {
namespace {

Duration MonotonicNow() { return std::chrono::steady_clock::now().time_since_epoch(); }

}  // namespace

SteadyClock::SteadyClock()
    : unix_minus_monotonic_(std::chrono::system_clock::now().time_since_epoch() - MonotonicNow()) {}

TimePoint SteadyClock::Now() const { return TimePoint{unix_minus_monotonic_ + MonotonicNow()}; }

}  // namespace eod
