#pragma once

#include <span>
#include <vector>

#include "sim/bodies/rigid_bodies.h"
#include "sim/disposal/disposal_status.h"
#include "sim/disposal/hand.h"
#include "sim/rules/disposal_rules.h"

namespace eod::sim {

/// Free hands that close on charges: which one presses which, and when it has to stop.
///
/// Respond stops a hand whose lines are inside a charge. One that presses it with another part of
/// its pad stops here, when the pad yields no more; and goes on when the pad has come back by half,
/// so that a charge that gives way a little between the hands does not let them start and stop.
class PressingHands {
 public:
  /// `module` must outlive it.
  PressingHands(const HandLayout& hand, const ModuleModel& module, const GraspRules& rules);
  void Reset();

  /// One step. `X_ML`, `bodies`: where robot and movables are. `close`: free hands are to close.
  /// Adds to `response` the hands that stop, and to `touched` (one a movable) what pads touch.
  void Update(bool close, const HandLines& lines, std::span<const Eigen::Isometry3d> X_ML,
              std::span<const BodyState> bodies, Response& response, std::span<char> touched);
  /// What they pressed is held now, or they open.
  void LetGo() { left_ = right_ = pinched_ = -1; }
  /// After a grasp was tried in vain: whether both can close no more. A charge yields a little now
  /// and then: pinched is pinched until the operator closes no more.
  void Pinch(const Response& response);

  /// Charge between two hands that close no more, as a movable's index; -1: none.
  int pinched() const { return pinched_; }

  /// What the box shows of hands that hold nothing.
  GraspState State(const HandLines& lines, bool closing) const;

 private:
  bool IsStopped(double press, bool was_stopped) const;

  HandLayout hand_;
  const ModuleModel& module_;
  GraspRules rules_;
  std::vector<int> charges_;
  int left_ = -1, right_ = -1, pinched_ = -1;
  int left_pad_ = -1, right_pad_ = -1;  ///< charge that stopped it by its pad
};

}  // namespace eod::sim
