#include "sim/camera/picture_schedule.h"

#include <algorithm>
#include <map>

namespace eod::sim {

PictureSchedule::PictureSchedule(size_t cameras, double rate_hz)
    : period_(static_cast<Duration::rep>(1e9 / rate_hz)),
      tolerance_(period_ / 4),
      turns_(cameras) {}

void PictureSchedule::Choose(std::span<const int> intervals, TimePoint now) {
  std::map<int, int> cameras_of;  // of each interval, so far
  for (size_t camera = 0; camera < turns_.size(); ++camera) {
    Turn& turn = turns_[camera];
    const int interval = intervals[camera];
    const int place = cameras_of[interval]++;
    if (interval == turn.interval) continue;
    turn.interval = interval;
    if (interval > 0) turn.due = now + place % interval * period_;
  }
}

/// Time that jumped back (a new run) must not silence a camera.
bool PictureSchedule::IsStale(const Turn& turn, TimePoint now) const {
  return *turn.due > now + (turn.interval + 1) * period_;
}

std::optional<size_t> PictureSchedule::Due(TimePoint now) const {
  std::optional<size_t> longest;
  for (size_t camera = 0; camera < turns_.size(); ++camera) {
    const Turn& turn = turns_[camera];
    if (turn.interval == 0) continue;
    const bool is_due = !turn.due || *turn.due - tolerance_ <= now || IsStale(turn, now);
    if (is_due && (!longest || turn.due < turns_[*longest].due)) longest = camera;
  }
  return longest;
}

void PictureSchedule::Drawn(size_t camera, TimePoint now) {
  Turn& turn = turns_.at(camera);
  if (!turn.due || IsStale(turn, now)) turn.due = now;
  // Whole periods only: who hands out snapshots at the same rate stays in step with this.
  const Duration period = turn.interval * period_;
  const Duration late = std::max(now - *turn.due, Duration::zero());
  *turn.due += period * (late / period + 1);
}

}  // namespace eod::sim
