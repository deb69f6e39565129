#include "recorder/bus_load.h"

namespace eod::recorder {

void BusLoad::Add(const CanFrame& frame) {
  if (any_) {
    bits_ += WorstCaseBits(frame);
  } else {
    first_ = frame.stamp;
    any_ = true;
  }
  last_ = frame.stamp;
}

double BusLoad::percent() const {
  if (!any_ || last_ <= first_) return 0;
  return 100.0 * static_cast<double>(bits_) / (ToSeconds(last_ - first_) * bit_rate_);
}

}  // namespace eod::recorder
