#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "sim/bodies/bullet_space.h"
#include "sim/bodies/ground_mesh.h"
#include "sim/bodies/link_bodies.h"
#include "sim/bodies/movable_body.h"
#include "sim/bodies/rigid_bodies.h"

namespace eod::sim {

/// What RigidBodies hides: Bullet, and when it need not be asked.
class RigidBodies::Engine {
 public:
  Engine(const ModuleModel& module, const RobotModel& robot);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  void Reset();
  void SetStart(int body, const std::optional<Eigen::Isometry3d>& X_MO);
  void Step(double dt_s, std::span<const Eigen::Isometry3d> X_ML);
  std::span<const BodyState> states() const { return states_; }

  void Hold(int body);
  void MoveHeld(int body, const Eigen::Isometry3d& X_MO);
  void Release(int body);
  void Remove(int body);
  void Push(int body, const Eigen::Vector3d& impulse_M, const Eigen::Vector3d& p_M);

 private:
  /// How a held body came to where it is.
  struct Grip {
    Eigen::Isometry3d X_before, X_now;  ///< of the last two MoveHelds
    Eigen::Isometry3d X_in_step;        ///< where the last step left it
  };

  void WarmUp();
  void TakeAllOut();
  bool IsFree(size_t body) const { return !states_[body].is_held && !states_[body].is_gone; }
  bool IsGripMoving(size_t body) const;
  bool IsGripNear(size_t body);
  bool IsNearGround(const Eigen::AlignedBox3d& box);
  /// Whether anything moves, or may be moved by the robot.
  bool IsBusy(std::span<const Eigen::Isometry3d> X_ML);
  void FollowGrips();
  void KeepGrips(bool was_busy);
  void ReadStates();
  void ReadState(size_t body);
  void ReadContacts();
  void ReadContact(const btPersistentManifold& manifold);
  void UpdateBox(size_t body);
  void WakeAround(size_t body);
  void Wake(size_t body);

  BulletSpace space_;
  std::vector<MovableObject> objects_;          ///< as they start
  std::vector<Eigen::Isometry3d> X_MO_module_;  ///< where the module has them
  std::vector<char> settles_;                   ///< it was placed elsewhere
  std::array<GroundMesh, 2> ground_meshes_;
  LinkBodies links_;
  std::vector<std::unique_ptr<btRigidBody>> ground_;
  std::vector<MovableBody> bodies_;
  std::vector<BodyState> states_;
  std::vector<Grip> grips_;
  std::vector<Eigen::AlignedBox3d> boxes_;  ///< round each body; empty if it is gone or held
  Eigen::AlignedBox3d in_the_air_;          ///< where a held body was last, and no ground is
  bool is_awake_ = false;
  double dt_s_ = 0;  ///< of the last step
};

}  // namespace eod::sim
