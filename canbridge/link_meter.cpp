#include "canbridge/link_meter.h"

#include <algorithm>
#include <numeric>

namespace eod::bridge {
namespace {

constexpr Duration kSlotLength = std::chrono::milliseconds(100);

}  // namespace

void LinkMeter::Count(TimePoint now) {
  Forget(now);
  ++counts_[static_cast<std::size_t>(slot_ % kSlots)];
}

double LinkMeter::Quality(TimePoint now) {
  Forget(now);
  const int valid = std::accumulate(counts_.begin(), counts_.end(), 0);
  // The youngest slot is still filling: what is due counts up to now.
  const double part = ToSeconds(now.time_since_epoch() % kSlotLength) / ToSeconds(kSlotLength);
  const double due = due_per_second_ * (kSlots - 1 + part) / kSlots;
  return std::min(1.0, valid / due);
}

void LinkMeter::Forget(TimePoint now) {
  const int64_t slot = now.time_since_epoch() / kSlotLength;
  const int64_t gone = std::min<int64_t>(slot - slot_, kSlots);
  for (int64_t i = 1; i <= gone; ++i)
    counts_[static_cast<std::size_t>((slot - gone + i) % kSlots)] = 0;
  slot_ = std::max(slot_, slot);
}

}  // namespace eod::bridge
