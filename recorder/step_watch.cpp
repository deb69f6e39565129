#include "recorder/step_watch.h"

#include <algorithm>

namespace eod::recorder {

void StepWatch::Add(TimePoint time, int64_t step) {
  // A simulator that was started again counts from zero: go on from there.
  if (any_ && step > last_step_ && time > last_time_) {
    ++gaps_[{time - last_time_, step - last_step_}];
  }
  any_ = true;
  last_step_ = step;
  last_time_ = time;
}

StepWatch::Total StepWatch::Sum() const {
  Total total;
  if (gaps_.empty()) return total;
  // The shortest step had no overrun; it is exact to the microsecond to which states tell the time.
  Duration shortest = Duration::max();
  for (const auto& [gap, count] : gaps_) shortest = std::min(shortest, gap.elapsed / gap.steps);
  for (const auto& [gap, count] : gaps_) {
    const int64_t periods = (gap.elapsed + shortest / 2) / shortest;
    total.elapsed += gap.elapsed * count;
    total.steps += gap.steps * count;
    total.overruns += std::max<int64_t>(0, periods - gap.steps) * count;
  }
  return total;
}

Duration StepWatch::period() const {
  const Total total = Sum();
  const int64_t periods = total.steps + total.overruns;
  return periods > 0 ? total.elapsed / periods : Duration{};
}

int64_t StepWatch::overruns() const { return Sum().overruns; }

Duration StepWatch::simulated() const { return period() * Sum().steps; }

}  // namespace eod::recorder
