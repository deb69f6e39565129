#pragma once

#include <array>
#include <cstdint>

#include "dbc/box_codec.h"
#include "platform/time.h"

namespace eod::box {

/// When each cyclic frame is due: start + offset + k * cycle, exact multiples for ever.
///
/// A late tick sends what is due and leaves the schedule where it was, so frames never come slower
/// than declared. After a pause longer than a cycle the stale frames are left out and counted.
/// Offsets are fixed and differ, so that the frames of one cycle do not queue behind one another.
class TransmitSchedule {
 public:
  /// Frames due at one tick, in the order of sending.
  struct Batch {
    std::array<dbc::BoxMessage, dbc::kBoxMessageCount> role{};
    int count = 0;
    const dbc::BoxMessage* begin() const { return role.data(); }
    const dbc::BoxMessage* end() const { return role.data() + count; }
    bool Contains(dbc::BoxMessage wanted) const;
  };

  explicit TransmitSchedule(const dbc::BoxCodec& codec);

  void StartHeartbeat(TimePoint start);
  /// Starts everything else that has a cycle time (process data, in CANopen's words).
  void StartProcessData(TimePoint start);
  void StopAll();

  /// Takes what is due at `now`.
  Batch TakeDue(TimePoint now);

  /// Largest delay of a frame of the last batch, and of all, against the schedule.
  Duration late() const { return late_; }
  Duration max_late() const { return max_late_; }
  /// Frames left out because a pause was longer than their cycle.
  uint64_t skipped() const { return skipped_; }

  static Duration Offset(dbc::BoxMessage role);

 private:
  struct Entry {
    Duration cycle{};  ///< zero: sent on events only
    TimePoint due{};
    bool running = false;
  };
  void Start(int index, TimePoint start);

  std::array<Entry, dbc::kBoxMessageCount> entries_;
  Duration late_{};
  Duration max_late_{};
  uint64_t skipped_ = 0;
};

}  // namespace eod::box
