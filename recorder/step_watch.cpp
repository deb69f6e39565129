#include "recorder/step_watch.h"

namespace eod::recorder {

void StepWatch::Add(TimePoint time, int64_t step, int64_t overruns) {
  // A simulator that was started again counts from zero: go on from there.
  if (any_ && step > last_step_ && time > last_time_) {
    steps_ += step - last_step_;
    overruns_ += overruns - last_overruns_;
    if (overruns == last_overruns_) {
      undisturbed_ += time - last_time_;
      undisturbed_steps_ += step - last_step_;
    }
  }
  any_ = true;
  last_time_ = time;
  last_step_ = step;
  last_overruns_ = overruns;
}

Duration StepWatch::period() const {
  return undisturbed_steps_ > 0 ? undisturbed_ / undisturbed_steps_ : Duration{};
}

}  // namespace eod::recorder
