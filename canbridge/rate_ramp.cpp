#include "canbridge/rate_ramp.h"

#include <algorithm>

namespace eod::bridge {

void RateRamp::Start(const MotionRates& from, TimePoint start, Duration length) {
  from_ = from;
  start_ = start;
  length_ = length;
}

MotionRates RateRamp::At(TimePoint now) const {
  const double share = std::clamp(1 - ToSeconds(now - start_) / ToSeconds(length_), 0.0, 1.0);
  MotionRates rates = from_;
  for (double& rate : rates) rate *= share;
  return rates;
}

}  // namespace eod::bridge
