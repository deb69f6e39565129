#pragma once

#include <array>
#include <optional>

#include "dbc/box_codec.h"
#include "platform/time.h"

namespace eod::bridge {

/// When each robot message is due: by its cycle time, spread by offsets so that they do not crowd,
/// and on change with a minimum gap between two on-change frames of one message.
class TransmitSchedule {
 public:
  using CycleTimes = std::array<Duration, dbc::kRobotMessageCount>;

  /// A cycle time of zero means: never by time.
  TransmitSchedule(const CycleTimes& cycle_times, Duration change_gap);

  /// True if the cyclic frame is due, and then takes it off the schedule. Frames that were missed
  /// are not caught up.
  bool TakeCyclic(dbc::RobotMessage role, TimePoint now);
  /// True if a change may be sent now, and then starts the gap.
  bool TakeChange(dbc::RobotMessage role, TimePoint now);

  /// Time of the first cyclic frame after the start.
  static Duration OffsetOf(dbc::RobotMessage role, Duration cycle_time);

 private:
  CycleTimes cycle_times_;
  Duration change_gap_;
  std::array<std::optional<TimePoint>, dbc::kRobotMessageCount> due_;
  std::array<std::optional<TimePoint>, dbc::kRobotMessageCount> last_change_;
};

}  // namespace eod::bridge
