#include "sim/radio/link_guard.h"

#include <algorithm>

namespace eod::sim {

void LinkGuard::Accept(TimePoint arrived, bool neutral, int32_t resets) {
  // First what the silence before this command means, then the command.
  Advance(arrived);
  if (heard_ && resets != resets_) latched_ = false;
  heard_ = true;
  resets_ = resets;
  last_ = std::max(last_, arrived);
  is_alive_ = true;
  silence_ = {};
  if (neutral && !latched_) stopped_ = false;
}

void LinkGuard::Advance(TimePoint now) {
  if (!heard_) return;
  const Duration age = now - last_;
  is_alive_ = age <= limits_.command_age;
  silence_ = is_alive_ ? Duration{} : age;
  if (!is_alive_ && !stopped_) {
    stopped_ = true;
    ramp_start_ = last_ + limits_.command_age;
  }
  if (age > limits_.latch_age) latched_ = true;
  share_ = stopped_ && !latched_
               ? std::clamp(1 - ToSeconds(now - ramp_start_) / ToSeconds(limits_.ramp), 0.0, 1.0)
               : 0;
}

}  // namespace eod::sim
