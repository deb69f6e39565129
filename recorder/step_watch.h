#pragma once

#include <cstdint>

#include "platform/time.h"

namespace eod::recorder {

/// Follows the simulator's steps by the robot states.
///
/// A state carries the scheduled time of its step, its number, and how many steps were not done in
/// their own period so far; the simulator counts those itself, since from outside a step that came
/// late looks like a message that did.
class StepWatch {
 public:
  void Add(TimePoint time, int64_t step, int64_t overruns);

  /// Mean time of a step where none was left out; zero until two such states were seen.
  Duration period() const;
  /// Overruns while this watched; a simulator that was started again counts anew.
  int64_t overruns() const { return overruns_; }
  /// Simulated time: steps times period.
  Duration simulated() const { return period() * steps_; }

 private:
  bool any_ = false;
  TimePoint last_time_{};
  int64_t last_step_ = 0;
  int64_t last_overruns_ = 0;
  int64_t steps_ = 0;
  int64_t overruns_ = 0;
  Duration undisturbed_{};         ///< time between states without an overrun in between ...
  int64_t undisturbed_steps_ = 0;  ///< ... and their steps
};

}  // namespace eod::recorder
