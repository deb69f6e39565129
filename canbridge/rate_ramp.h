#pragma once

#include <array>

#include "dbc/panel_state.h"
#include "platform/time.h"

namespace eod::bridge {

using MotionRates = std::array<double, dbc::kMotionCount>;

/// Takes all motions to zero together, linearly.
class RateRamp {
 public:
  void Start(const MotionRates& from, TimePoint start, Duration length);
  /// Zero before `Start` and after `Cancel`.
  MotionRates At(TimePoint now) const;
  void Cancel() { from_ = {}; }

 private:
  MotionRates from_{};
  TimePoint start_{};
  Duration length_{1};
};

}  // namespace eod::bridge
