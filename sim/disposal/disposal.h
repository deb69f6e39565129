#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/bodies/rigid_bodies.h"
#include "sim/disposal/charge_watch.h"
#include "sim/disposal/disposal_status.h"
#include "sim/disposal/fire_circuit.h"
#include "sim/disposal/grasp.h"
#include "sim/disposal/held_probe.h"
#include "sim/disposal/pressing_hands.h"
#include "sim/disposal/push_through.h"
#include "sim/disposal/shot.h"
#include "sim/rules/rules.h"

namespace eod::sim {

/// What a step has found before the robot moves. Spans and pointers are read during the call alone.
struct BeforeMotion {
  double dt_s = 0;
  const RobotState* state = nullptr;
  std::span<const Eigen::Isometry3d> X_ML;  ///< of that state: the segments were cast from there
  std::span<const CastSegment> segments;
  const MotionDemand* demand = nullptr;
  std::span<const BodyState> bodies;  ///< one a movable of the module, where the segments met them
  std::span<const int> movable_of_object;  ///< by the world's number; -1 or beyond its end: none
  double payload = 0;                      ///< [kg] that the arm bears at this reach
  bool pads_slip = false;                  ///< they hold nothing for long
};

/// What a step has come to after the motion and the ground.
struct AfterMotion {
  double dt_s = 0;
  int64_t step = 0;
  const RobotState* state = nullptr;
  std::span<const Eigen::Isometry3d> X_ML;  ///< of that state
  std::span<const BodyState> bodies;        ///< as in BeforeMotion
  std::span<const int> movable_of_object;
  const World* world = nullptr;
  FirePanel panel;
  bool robot_is_still = false;
  bool rolled_over = false;
};

/// What hands and charges say to the motions of a step, apart from what stands in the Response.
struct MotionVerdict {
  bool left_hand_stopped = false;  ///< while closing: for MotionDemand
  bool right_hand_stopped = false;
  MotionSet let_through = 0;  ///< blocked motions that push a charge on all the same ...
  std::array<double, kMotionCount> most{};  ///< ... at this rate at most
};

/// For RigidBodies, to be done in this order; -1: nothing.
struct DisposalOrders {
  int hold = -1;
  int move_held = -1;  ///< to X_MO
  Eigen::Isometry3d X_MO = Eigen::Isometry3d::Identity();
  int release = -1;
  int remove = -1;
  int push = -1;  ///< with impulse_M [N s] at p_M
  Eigen::Vector3d impulse_M = Eigen::Vector3d::Zero();
  Eigen::Vector3d p_M = Eigen::Vector3d::Zero();
  int reload_isector = -1;  ///< for IsectorSet: the held charge's lines have changed
};

/// Charges, gripper and disrupter of one robot in one module: what touches, is grasped, carried,
/// dropped, fired at, and goes off. Pure: it reads bodies and gives orders for them. Neither call
/// allocates.
class Disposal {
 public:
  /// `robot`, `module` must outlive it. `probe`: index in `robot.isectors` of the held charge's
  /// lines, see AppendHeldProbe; they are changed as charges are grasped and let go of.
  Disposal(RobotModel& robot, int probe, const ModuleModel& module, const Rules& rules,
           GraspMode mode, uint64_t seed = 0);

  /// The module is entered anew. IsectorSet::Reload(probe) has to follow.
  void Reset() { Reset(circuit_.seed()); }
  void Reset(uint64_t seed);

  /// After Respond, before the motion. Adds to `response` that a hand whose pad is pressed through
  /// stops closing. Decides grasps, squeezing and strikes against a vessel.
  const MotionVerdict& Judge(const BeforeMotion& step, Response& response);

  /// After motion and stance, before the bodies' step. `orders()` are to be carried out then.
  const DisposalStatus& Advance(const AfterMotion& step);

  const DisposalOrders& orders() const { return orders_; }
  const DisposalStatus& status() const { return status_; }
  /// The charges one by one, for the instructor.
  std::span<const ChargeState> charges() const { return watch_.charges(); }
  /// No line may see this movable now: it is held, or blown up.
  bool Ignores(int body) const;
  /// [kg] of what is held; 0 if nothing is.
  double held_mass() const;

 private:
  const ExplosiveSpec& Explosive(int body) const { return *module_.movables[body].explosive; }
  void NoteTouches(const BeforeMotion& step, const Response& response);
  void TryGrasp(const BeforeMotion& step, const HandLines& lines);
  void CheckRim(const BeforeMotion& step, const Response& response);
  Eigen::Vector3d GripperVelocity(const BeforeMotion& step, const Eigen::Vector3d& p_M) const;
  double RelativeSpeed(const BeforeMotion& step, const BodyState& body) const;
  GraspState GraspOf(const HandLines& lines, bool closing) const;

  void Carry(const AfterMotion& step);
  void LetGo();
  void ShapeProbe(const Eigen::Vector3d& down_G);
  void Shoot(const AfterMotion& step);
  void Watch(const AfterMotion& step);
  void Detonate(int body, DetonationCause cause, const AfterMotion& step);
  Eigen::Vector3d GroundBelow(int body, const AfterMotion& step);
  void FillStatus();

  RobotModel& robot_;
  int probe_;
  const ModuleModel& module_;
  Rules rules_;
  HandLayout hand_;
  int wrist_;
  Grasp grasp_;
  PressingHands pressing_;
  PushThrough push_;
  ChargeWatch watch_;
  FireCircuit circuit_;
  CastMemory memory_;

  // From step to step.
  std::optional<Eigen::Isometry3d> X_MG_before_;  ///< where the gripper was in the last Judge
  double closing_age_ = 0;                        ///< [s] since closing was commanded
  bool was_released_ = false;
  double fall_speed_ = 0;  ///< [m/s] of the robot, in the last Advance

  // From Judge to Advance.
  std::vector<char> touched_;  ///< one a movable
  std::optional<Detonation> judged_;
  bool opening_ = false;
  bool too_heavy_ = false;
  int newly_held_ = -1;

  MotionVerdict verdict_;
  DisposalOrders orders_;
  DisposalStatus status_;
};

}  // namespace eod::sim
