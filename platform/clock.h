#pragma once

#include "platform/time.h"

namespace eod {

/// Source of the current moment. Only mains and test rigs own one; everything else is handed `now`.
class Clock {
 public:
  virtual ~Clock() = default;
  virtual TimePoint Now() const = 0;
};

/// Unix time taken once at construction, then advanced by the monotonic clock, so it never steps.
class SteadyClock final : public Clock {
 public:
  SteadyClock();
  TimePoint Now() const override;

 private:
  Duration unix_minus_monotonic_;
};

/// Time that stands still until it is told otherwise: lock-step and tests.
class ManualClock final : public Clock {
 public:
  explicit ManualClock(TimePoint start = TimePoint{}) : now_(start) {}
  TimePoint Now() const override { return now_; }
  void Advance(Duration by) { now_ += by; }

 private:
  TimePoint now_;
};

}  // namespace eod
