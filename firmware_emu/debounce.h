#pragma once

#include "platform/time.h"

namespace eod::box {

/// A switch as the firmware believes it: a new position counts once it has been seen at every tick
/// for `settle`.
template <typename Position>
class Debounced {
 public:
  explicit Debounced(Position initial) : value_(initial), candidate_(initial) {}

  Position Update(TimePoint now, Position raw, Duration settle) {
    if (raw != candidate_) {
      candidate_ = raw;
      since_ = now;
    }
    if (candidate_ != value_ && now - since_ >= settle) value_ = candidate_;
    return value_;
  }

  /// Takes `position` without waiting: the safe direction of a safety switch.
  void Force(Position position) { value_ = candidate_ = position; }

  Position value() const { return value_; }

 private:
  Position value_;
  Position candidate_;
  TimePoint since_{};
};

/// A contact that bounces: after each change of the lever it alternates, tick by tick, between the
/// old and the new position for `bounce_time`, and only then rests.
template <typename Position>
class BouncingContact {
 public:
  explicit BouncingContact(Position initial) : lever_(initial), previous_(initial) {}

  Position Update(TimePoint now, Position lever, Duration bounce_time) {
    if (lever != lever_) {
      previous_ = lever_;
      lever_ = lever;
      moved_ = now;
      flip_ = false;
    }
    if (now - moved_ >= bounce_time) return lever_;
    flip_ = !flip_;
    return flip_ ? lever_ : previous_;
  }

 private:
  Position lever_;
  Position previous_;
  TimePoint moved_{};
  bool flip_ = false;
};

}  // namespace eod::box
