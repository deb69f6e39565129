#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "sim/robot/robot_model.h"
#include "sim/world/world_model.h"

namespace eod::sim {

/// How a movable object stands in a step.
struct BodyState {
  Eigen::Isometry3d X_MO = Eigen::Isometry3d::Identity();  ///< in the module's frame
  Eigen::Vector3d v_M = Eigen::Vector3d::Zero();           ///< [m/s] of its origin
  Eigen::Vector3d w_M = Eigen::Vector3d::Zero();           ///< [rad/s]
  bool is_moving = false;                                  ///< not at rest
  bool is_held = false;                                    ///< follows a gripper
  bool is_gone = false;                                    ///< removed: it is nowhere any more
  uint32_t touched_by = 0;      ///< robot parts in contact with it in this step, bits of Part
  bool touches_ground = false;  ///< anything static, in this step
};

/// The movable objects of one module as rigid bodies: on the static triangles, among each other,
/// and pushed by the robot's links, which nothing pushes back. Deterministic: same calls, same
/// bits. Numbers are indices in ModuleModel::movables. No allocation after the first steps.
class RigidBodies {
 public:
  /// `robot` must outlive the bodies. All stand where the module has them, at rest.
  RigidBodies(const ModuleModel& module, const RobotModel& robot);
  ~RigidBodies();

  /// Everything back to the start.
  void Reset();

  /// From the next Reset on the body starts there, and settles on what is below it; without a pose
  /// it is where the module has it, at rest.
  void SetStart(int body, const std::optional<Eigen::Isometry3d>& X_MO);

  /// Advances by dt, with the robot's links moving to `X_ML` meanwhile. Costs next to nothing while
  /// all is at rest and the robot is not near.
  void Step(double dt_s, std::span<const Eigen::Isometry3d> X_ML);

  std::span<const BodyState> states() const;

  /// From now on the body follows MoveHeld, whatever stands in its way.
  void Hold(int body);
  void MoveHeld(int body, const Eigen::Isometry3d& X_MO);
  /// Lets go of it with the velocity of the last MoveHelds.
  void Release(int body);
  /// Takes it out of the world.
  void Remove(int body);
  /// A blow: [N s] at a point of the module's frame.
  void Push(int body, const Eigen::Vector3d& impulse_M, const Eigen::Vector3d& p_M);

 private:
  class Engine;
  std::unique_ptr<Engine> engine_;
};

}  // namespace eod::sim
