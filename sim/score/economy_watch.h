#pragma once

#include <array>

#include "sim/rules/score_rules.h"
#include "sim/score/score_event.h"

namespace eod::sim {

struct EconomyCount {
  int reversals = 0;
  int undone = 0;
  int limits = 0;
};

/// Motions that were for nothing: driving or turning back within `reversal_time` of standing still,
/// a motion of flippers or arm (J1 to J6) that is taken back within it, a joint driven against its
/// limit. Looking round, and opening and closing the gripper, is never for nothing.
class EconomyWatch {
 public:
  explicit EconomyWatch(const ScoreRules& rules) : rules_(rules) {}
  void Reset() { *this = EconomyWatch(rules_); }
  void Advance(const ScoreMoment& moment, EventList& events);
  const EconomyCount& count() const { return count_; }

 private:
  /// One way of moving, to and fro.
  struct Stroke {
    int direction = 0;  ///< of the motion that goes on, or was the last
    double length = 0;  ///< so far
    double before = 0;  ///< length of the one before, if this one began at once after it
    double idle_s = 0;  ///< since it moved last
    bool blamed = false;
  };
  static constexpr int kJoints = 6;
  /// Whether a stroke the other way begins in time.
  bool Turns(Stroke& stroke, double moved, double dt_s) const;
  void WatchChassis(const ScoreMoment& moment, EventList& events);
  void WatchJoints(const ScoreMoment& moment, EventList& events);
  void WatchLimits(const ScoreMoment& moment, EventList& events);

  ScoreRules rules_;
  EconomyCount count_;
  std::array<Stroke, 2> chassis_{};  ///< driving, turning
  std::array<Stroke, kJoints> joints_{};
  std::array<double, kJoints> coordinate_{};
  bool has_coordinates_ = false;
  uint32_t at_limit_ = 0;  ///< joints that were driven against the limit they stand on
};

}  // namespace eod::sim
