#pragma once

#include <array>
#include <cstdint>

#include "platform/time.h"

namespace eod::bridge {

/// Share of valid frames among those due in the last second.
class LinkMeter {
 public:
  /// `due_per_second`: sum of the declared rates of the frames that are counted, > 0.
  explicit LinkMeter(double due_per_second) : due_per_second_(due_per_second) {}

  void Count(TimePoint now);
  /// 0..1.
  double Quality(TimePoint now);

 private:
  static constexpr int kSlots = 10;  // of 100 ms
  void Forget(TimePoint now);

  double due_per_second_;
  std::array<int, kSlots> counts_{};
  int64_t slot_ = 0;
};

}  // namespace eod::bridge
