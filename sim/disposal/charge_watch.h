#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/bodies/rigid_bodies.h"
#include "sim/disposal/disposal_status.h"
#include "sim/rules/disposal_rules.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// What is known of one charge.
struct ChargeState {
  int body = -1;  ///< index in ModuleModel::movables
  BombState state = BombState::kPlaced;
  double tilt = 0;         ///< [rad] of its axis from how it rested at the start
  bool touched = false;    ///< by the robot, in this step; not while held
  bool disturbed = false;  ///< tilted beyond the first limit, standing
  bool unstable = false;   ///< beyond the second
  bool in_vessel = false;  ///< where a blast or a fall does no harm
  bool operator==(const ChargeState&) const = default;
};

/// A charge goes off.
struct Detonation {
  int body = -1;
  DetonationCause cause = DetonationCause::kNone;
};

/// Watches what happens to the charges of a module: touched, tilted, toppled, dropped, safe.
///
/// Tilt: against the vertical for a charge that stood at the start, against the level for one that
/// lay. Beyond `disturbed` and `unstable` it is told; beyond atan(a / h), where its weight no
/// longer rights it, it goes off as tipped (atan(h / a) if it lay). A charge that was let go of has
/// no tilt until it meets the ground: the drop rule looks after it. Fall: from the highest place
/// since it last lay on something or was held, to where it meets the ground; measured at its lowest
/// point. Inside of a vessel neither rule applies.
class ChargeWatch {
 public:
  /// `module` must outlive it.
  ChargeWatch(const ModuleModel& module, const ChargeRules& charge, const VesselRules& vessel);
  void Reset();

  /// `touched`: one a movable, whether lines of the robot are in contact with it; may be shorter.
  /// `held`: the charge in the hand, -1 if none. Returns the first charge that goes off now.
  std::optional<Detonation> Update(std::span<const BodyState> bodies, std::span<const char> touched,
                                   int held);

  /// It is safe for good, or gone: no rule applies any more.
  void Disrupt(int body) { Settle(body, BombState::kDisrupted); }
  void Explode(int body) { Settle(body, BombState::kExploded); }

  /// In the order of the module.
  std::span<const ChargeState> charges() const { return charges_; }
  /// nullptr if `body` is no charge.
  const ChargeState* Find(int body) const;
  /// The charge that matters: in the hand, else the one last touched or let go of, else the first.
  /// nullptr in a module without.
  const ChargeState* main() const;

 private:
  /// Behind a ChargeState.
  struct History {
    bool lies = false;      ///< at the start
    bool airborne = false;  ///< let go of, and has not met the ground since
    bool was_held = false;
    double highest = 0;  ///< [m] of its lowest point since it last lay on something
    Eigen::Vector3d p_taken = Eigen::Vector3d::Zero();  ///< where it was grasped
  };
  void Settle(int body, BombState state);
  DetonationCause UpdateOne(size_t index, const BodyState& body, bool touched, bool held);
  void UpdateHeld(ChargeState& charge, History& history, const BodyState& body) const;
  DetonationCause UpdateFree(ChargeState& charge, History& history, const BodyState& body) const;
  double TiltOf(const History& history, const BodyState& body) const;
  bool IsInVessel(const BodyState& body, double lowest) const;

  const ModuleModel& module_;
  ChargeRules charge_rules_;
  VesselRules vessel_rules_;
  std::vector<ChargeState> charges_;
  std::vector<History> histories_;  ///< one a charge
  int main_ = 0;                    ///< index in charges_
};

}  // namespace eod::sim
