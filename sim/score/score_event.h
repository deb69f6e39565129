#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "sim/score/score_sample.h"

namespace eod::sim {

/// What a judge takes note of.
enum class ScoreMark : uint8_t {
  kStep,  ///< completed
  kCollision,
  kPushing,
  kTilt,
  kTouch,
  kFireButton,  ///< pressed without a ready circuit
  kOneHand,     ///< one button alone for too long
  kArmedDriving,
  kFireTimeOut,
  kUnseen,
  kProcedure,  ///< missing, out of order or broken
  kReversal,
  kUndone,
  kLimit,
  kMeasured,  ///< a measure of precision was taken
  kFailed,
};

/// One of these, at its moment.
struct ScoreEvent {
  ScoreMark mark = ScoreMark::kStep;
  double time_s = 0;                                   ///< of the mission
  double points = 0;                                   ///< gained, or lost if negative
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m] of the robot, local
  int index = -1;     ///< step, joint, item of the check list, measure, fail reason
  int object = -1;    ///< in the module's names; -1 none
  double amount = 0;  ///< seconds of pushing, degrees of tilt, what was measured
};

/// The moment that is judged.
struct ScoreMoment {
  const ScoreSample* now = nullptr;
  double dt_s = 0;                                     ///< of the mission's clock: 0 in a pause
  Eigen::Vector3d p_M = Eigen::Vector3d::Zero();       ///< [m] of the robot's origin
  Eigen::Vector3d charge_M = Eigen::Vector3d::Zero();  ///< [m] of the charge that matters
  double way = 0;                                      ///< [m] driven on the map in this step
  int step_before = 0;  ///< the task's step that was to be done as this one began
  int contact = -1;     ///< in the module's names: what is touched
};

/// Events in the order of time, as many as there is room for. Never allocates after it was made.
class EventList {
 public:
  static constexpr size_t kRoom = 512;
  EventList() { events_.reserve(kRoom); }

  void Clear();
  /// Notes an event of this moment. Its place, for Extend; -1 if there was no room.
  int Add(const ScoreMoment& moment, ScoreMark mark, double points, int index = -1, int object = -1,
          double amount = 0);
  /// What goes on for a while grows.
  void Extend(int place, double points, double amount);
  /// The event was not here but at an earlier time [s].
  void Antedate(int place, double time_s);

  const std::vector<ScoreEvent>& events() const { return events_; }
  /// Events that found no room. Their points count all the same.
  int left_out() const { return left_out_; }

 private:
  std::vector<ScoreEvent> events_;
  int left_out_ = 0;
};

}  // namespace eod::sim
