#pragma once

#include <vector>

#include "sim/rules/rules.h"
#include "sim/scenario/scenario.h"
#include "sim/score/score_event.h"

namespace eod::sim {

/// How often, or for how long, a rule of safety was broken, and the points for that.
struct SafetyCount {
  int collisions = 0;  ///< that no step asked for
  double pushing_s = 0;
  int tilts = 0;
  int touches = 0;
  int fire_rules = 0;
  int unseen = 0;
};

/// Collisions, pushing on, tilt, touched charges and driving unseen.
///
/// A collision is a part that comes into contact. Steps `contact` and `grasp` ask for those with
/// their object, `climb` and `reach` for those with an object that they name (stairs are touched),
/// `place_in_vessel` for those that the held charge makes with the vessel. Pushing on counts beyond
/// `push_grace`. A charge that is touched counts unless it is grasped then or was just let go of.
/// Driving counts as unseen after `unseen_way` without a camera on the way ahead: quad, drive or
/// mast forward; quad, rear or mast backward. It counts again after the way was seen, or the
/// direction changed.
class SafetyWatch {
 public:
  SafetyWatch(const Scenario& scenario, const Rules& rules);
  void Reset();
  /// `objects[i]`: index of the object of step i in the module's names, -1 for any.
  void Advance(const ScoreMoment& moment, std::span<const int> objects, EventList& events);
  const SafetyCount& count() const { return count_; }
  /// [rad] what the tilt must not exceed
  double tilt_limit() const { return tilt_limit_; }

 private:
  void WatchContacts(const ScoreMoment& moment, std::span<const int> objects, EventList& events);
  bool IsAskedFor(const ScoreMoment& moment, std::span<const int> objects) const;
  void WatchPushing(const ScoreMoment& moment, EventList& events);
  void WatchTilt(const ScoreMoment& moment, EventList& events);
  void WatchTouches(const ScoreMoment& moment, EventList& events);
  void WatchFire(const ScoreMoment& moment, EventList& events);
  void WatchButton(const ScoreMoment& moment, bool pressed, bool other, int button,
                   EventList& events);
  void WatchView(const ScoreMoment& moment, EventList& events);

  std::vector<TaskStep::Kind> kinds_;  ///< of the steps
  ScoreRules rules_;
  double both_within_;
  double tilt_limit_;
  SafetyCount count_;

  uint32_t contacts_ = 0;
  double pushed_s_ = 0;
  int pushing_event_ = -1;
  bool is_tilted_ = false;
  int tilt_event_ = -1;
  double tilt_peak_ = 0;   ///< [rad] of this time
  double touched_s_ = -1;  ///< since a charge was touched last; negative: no touch is open
  double touch_began_s_ = 0;
  double held_s_ = 0;  ///< since a charge was held last
  struct Button {
    double alone_s = 0;  ///< pressed without the other
    bool pressed = false;
    bool blamed = false;  ///< for this press
  };
  std::array<Button, 2> buttons_{};
  int fire_state_ = 0;
  bool armed_driving_ = false;
  double unseen_way_ = 0;
  int direction_ = 0;  ///< of driving: -1, 0, 1
};

}  // namespace eod::sim
