#pragma once

#include <cstdint>

#include <Eigen/Geometry>

#include "sim/disposal/disposal_status.h"
#include "sim/disposal/hand.h"

namespace eod::sim {

/// What makes a grasp: the five lines alone, as in the source paper, or the guards of 3.4 too.
enum class GraspMode : uint8_t { kPaper, kGuarded };

/// The charge that l1, l2, l3, l5 and l9 all see; -1 unless all see one and the same (3.4).
int GraspCandidate(const HandLines& lines);

/// A charge between the hands, as the guards look at it.
struct Grip {
  HandLines lines;
  ExplosiveSpec charge;
  Eigen::Isometry3d X_MO = Eigen::Isometry3d::Identity();
  Eigen::Vector3d closing_M = Eigen::Vector3d::UnitX();  ///< unit, across the jaws
  double gap = 0;                                        ///< [m] xR - xL, between the pads' faces
  double relative_speed = 0;  ///< [m/s] of the charge against the gripper
  double tilt = 0;            ///< [rad] of the charge from how it rests
  double mass = 0;            ///< [kg] of the charge
  double payload = 0;         ///< [kg] at this reach
  double closing_age = 0;     ///< [s] since closing was last commanded
};

/// The guards that say that it will not slip out: nothing ahead of the right tip, contacts opposed,
/// the charge across the jaws, the hands as far apart as it is thick.
bool IsHeldWell(const Grip& grip, const GraspRules& rules);

/// All guards of 3.4.
bool GuardsHold(const Grip& grip, const GraspRules& rules);

/// Takes hold of charges and lets go of them. Knows lines, not bodies.
class Grasp {
 public:
  Grasp(const GraspRules& rules, GraspMode mode) : rules_(rules), mode_(mode) {}
  void Reset() { *this = Grasp(rules_, mode_); }

  /// A step with free hands: counts it if `grip` is of a candidate (nullptr: there is none).
  /// Whether the charge is grasped now.
  bool Close(int candidate, const Grip* grip);
  /// Notes how it is held, and the opening of each hand [m] then.
  void Hold(int charge, const Eigen::Isometry3d& X_GO, double left, double right, bool well);
  /// Whether the hands have opened far enough to let it go.
  bool IsLetGo(bool opening_commanded, double left, double right) const;
  /// Slips while held badly or `too_heavy`; `down_G` is the unit vertical, downwards, in the
  /// gripper's frame. Whether it has slipped out.
  bool Slip(bool too_heavy, const Eigen::Vector3d& down_G, double dt_s);
  void Release();

  /// Pressed from both sides by hands that can close no more, and no grasp: whether it went on too
  /// long.
  bool Squeeze(bool pressed, double dt_s);

  int charge() const { return charge_; }  ///< held; -1: none
  bool is_held() const { return charge_ >= 0; }
  bool is_slipping() const { return is_slipping_; }
  const Eigen::Isometry3d& X_GO() const { return X_GO_; }
  /// While held, the hands close no farther than they were then [m].
  double left_opening() const { return left_; }
  double right_opening() const { return right_; }

 private:
  GraspRules rules_;
  GraspMode mode_;
  int candidate_ = -1;
  int steps_ = 0;  ///< of the candidate, one after another
  int charge_ = -1;
  Eigen::Isometry3d X_GO_ = Eigen::Isometry3d::Identity();
  double left_ = 0, right_ = 0;
  bool well_ = true;
  bool is_slipping_ = false;
  double slipped_s_ = 0;
  double squeezed_s_ = 0;
};

}  // namespace eod::sim
