#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "platform/time.h"

namespace eod::sim {

/// Decides which camera is to be drawn, by the time of the snapshots alone: each at its rate, in
/// turn when there is not time for all. A camera that came late is not drawn twice to catch up.
class PictureSchedule {
 public:
  /// All at the full rate.
  PictureSchedule(size_t cameras, double rate_hz);

  /// From `now` on camera i has every `intervals[i]`th picture of the full rate, 0: none. Those of
  /// one interval take turns. A camera whose interval stays is not disturbed.
  void Choose(std::span<const int> intervals, TimePoint now);

  /// The camera that has waited longest, if one is due at `now`.
  std::optional<size_t> Due(TimePoint now) const;
  /// Camera `camera` was drawn from the snapshot of `now`.
  void Drawn(size_t camera, TimePoint now);

 private:
  struct Turn {
    int interval = 1;
    std::optional<TimePoint> due;  ///< empty: never drawn
  };
  bool IsStale(const Turn& turn, TimePoint now) const;

  Duration period_;
  Duration tolerance_;  ///< a snapshot that comes so much early will do
  std::vector<Turn> turns_;
};

}  // namespace eod::sim
