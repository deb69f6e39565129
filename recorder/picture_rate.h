#pragma once

#include <cstdint>
#include <deque>

#include "platform/time.h"

namespace eod::recorder {

/// Pictures a second of one camera among several of which the operator chooses: while others were
/// shown in its place it does not count as slow, but a time without any picture does.
class PictureRate {
 public:
  /// `last_of_any`: time of the picture before, of whichever camera.
  void OnPicture(TimePoint time, TimePoint last_of_any);

  int64_t frames() const { return frames_; }
  /// Of all the time that it was shown; 0 before the second picture.
  double mean_fps() const;
  /// Pictures of the second before `now`.
  double FpsAt(TimePoint now) const;

 private:
  int64_t frames_ = 0;
  Duration shown_{};
  std::deque<TimePoint> newest_;  ///< of the last second
};

}  // namespace eod::recorder
