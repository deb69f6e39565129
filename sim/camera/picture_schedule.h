#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "platform/time.h"

namespace eod::sim {

/// Decides which camera is to be drawn, by the time of the snapshots alone: each at its rate, in
/// turn when there is not time for all. A camera that came late is not drawn twice to catch up.
class PictureSchedule {
 public:
  PictureSchedule(size_t cameras, double rate_hz);

  /// The camera that has waited longest, if one is due at `now`.
  std::optional<size_t> Due(TimePoint now) const;
  /// Camera `camera` was drawn from the snapshot of `now`.
  void Drawn(size_t camera, TimePoint now);

 private:
  Duration period_;
  Duration tolerance_;                         ///< a snapshot that comes so much early will do
  std::vector<std::optional<TimePoint>> due_;  ///< empty: never drawn
};

}  // namespace eod::sim
