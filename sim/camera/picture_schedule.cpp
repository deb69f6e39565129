#include "sim/camera/picture_schedule.h"

#include <algorithm>

namespace eod::sim {

PictureSchedule::PictureSchedule(size_t cameras, double rate_hz)
    : period_(static_cast<Duration::rep>(1e9 / rate_hz)), tolerance_(period_ / 4), due_(cameras) {}

std::optional<size_t> PictureSchedule::Due(TimePoint now) const {
  std::optional<size_t> longest;
  for (size_t camera = 0; camera < due_.size(); ++camera) {
    // Time that jumped back (a new run) must not silence a camera.
    const bool is_due =
        !due_[camera] || *due_[camera] - tolerance_ <= now || *due_[camera] > now + 2 * period_;
    if (is_due && (!longest || due_[camera] < due_[*longest])) longest = camera;
  }
  return longest;
}

void PictureSchedule::Drawn(size_t camera, TimePoint now) {
  std::optional<TimePoint>& due = due_.at(camera);
  if (!due || *due > now + 2 * period_) due = now;
  // Whole periods only: who hands out snapshots at the same rate stays in step with this.
  const Duration late = std::max(now - *due, Duration::zero());
  *due += period_ * (late / period_ + 1);
}

}  // namespace eod::sim
