#include "canbridge/transmit_schedule.h"

namespace eod::bridge {
namespace {

// No two of the eleven messages share a millisecond of any 50 ms: 7 i mod 50 are all different.
constexpr Duration kStagger = std::chrono::milliseconds(7);

}  // namespace

TransmitSchedule::TransmitSchedule(const CycleTimes& cycle_times, Duration change_gap)
    : cycle_times_(cycle_times), change_gap_(change_gap) {}

Duration TransmitSchedule::OffsetOf(dbc::RobotMessage role, Duration cycle_time) {
  return static_cast<int>(role) * kStagger % cycle_time;
}

bool TransmitSchedule::TakeCyclic(dbc::RobotMessage role, TimePoint now) {
  const auto i = static_cast<std::size_t>(role);
  const Duration cycle_time = cycle_times_[i];
  if (cycle_time <= Duration::zero()) return false;
  std::optional<TimePoint>& due = due_[i];
  if (!due) due = now + OffsetOf(role, cycle_time);
  if (now < *due) return false;
  *due += ((now - *due) / cycle_time + 1) * cycle_time;
  return true;
}

bool TransmitSchedule::TakeChange(dbc::RobotMessage role, TimePoint now) {
  std::optional<TimePoint>& last = last_change_[static_cast<std::size_t>(role)];
  if (last && now - *last < change_gap_) return false;
  last = now;
  return true;
}

}  // namespace eod::bridge
