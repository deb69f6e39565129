#include "sim/battery/battery.h"

#include <algorithm>

namespace eod::sim {

void Battery::Reset() {
  charge_ = 1;
  current_ = 0;
  voltage_ = robot_.battery.full;
  is_low_ = false;
}

void Battery::Advance(const MotionDemand& moving, double sag, double dt_s) {
  const BatterySpec& spec = robot_.battery;
  current_ = spec.idle_current;
  for (int motion = 0; motion < kMotionCount; ++motion) {
    if (!Contains(moving.commanded, motion)) continue;
    const bool drives = Contains(kChassisMotions, motion);
    current_ += moving.rate[motion] * (drives ? spec.drive_current : spec.joint_current);
  }
  if (spec.capacity > 0) charge_ = std::max(0.0, charge_ - current_ * dt_s / spec.capacity);
  const double source = spec.empty + (spec.full - spec.empty) * charge_;
  voltage_ = std::max(0.0, source - spec.resistance * current_ - sag);
  is_low_ = voltage_ < spec.low;
}

}  // namespace eod::sim
