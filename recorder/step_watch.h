#pragma once

#include <compare>
#include <cstdint>
#include <map>

#include "platform/time.h"

namespace eod::recorder {

/// Finds the simulation's period and its overruns in the robot states.
///
/// A state carries the scheduled time of its step, a multiple of the period. A step that the
/// simulator missed leaves a hole in these times, yet not in the step numbers, because the
/// simulator does not catch up; a state that was lost on the way leaves both. So overruns are the
/// periods that passed beyond the steps that were counted, and lost messages do not look like
/// overruns.
class StepWatch {
 public:
  void Add(TimePoint time, int64_t step);

  /// Mean time of a step, overruns left out; zero until two states were seen.
  Duration period() const;
  int64_t overruns() const;
  /// Simulated time: steps times period.
  Duration simulated() const;

 private:
  /// From one state to the next: scheduled time and step numbers that passed.
  struct Gap {
    Duration elapsed{};
    int64_t steps = 0;
    auto operator<=>(const Gap&) const = default;
  };
  struct Total {
    Duration elapsed{};
    int64_t steps = 0;
    int64_t overruns = 0;
  };
  Total Sum() const;

  std::map<Gap, int64_t> gaps_;  ///< how often; few differ, since times are multiples of the period
  int64_t last_step_ = 0;
  TimePoint last_time_{};
  bool any_ = false;
};

}  // namespace eod::recorder
