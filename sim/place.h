#pragma once

#include <vector>

#include "sim/bodies/rigid_bodies.h"
#include "sim/disposal/disposal.h"
#include "sim/isectors/isector_set.h"
#include "sim/placing.h"
#include "sim/score/scorer.h"
#include "sim/stance/stance.h"
#include "sim/task/task.h"
#include "sim/world/built_world.h"

namespace eod::sim {

struct SimulatorConfig;

/// A module that the menu can choose, built before the first step: its world, what moves in it, and
/// the robot's senses there.
class Place {
 public:
  /// `robot` and `model` must outlive it; `probe` as Disposal has it. Nothing is to be done here
  /// until an exercise is loaded.
  Place(RobotModel& robot, int probe, const WorldModel& all, const ModuleModel& model,
        const SimulatorConfig& config);

  /// An exercise of this module that CheckFits has passed, from its start.
  void Load(const Scenario& scenario);
  /// The same exercise from its start.
  void Restart();

  /// Where the robot begins: on the ground nearest below a step above the scenario's start.
  StartPose Start();

  /// Carries out what disposal ordered, advances the bodies with the robot's links at `X_ML`, and
  /// has the world follow them.
  void MoveBodies(double dt_s, std::span<const Eigen::Isometry3d> X_ML);

  const ModuleModel& module() const { return module_; }
  /// X_MO of the movables, after the last MoveBodies.
  std::span<const Eigen::Isometry3d> poses() const { return poses_; }
  /// The same when the exercise began.
  std::span<const Eigen::Isometry3d> starts() const { return starts_; }
  std::span<const int> movable_of_object() const { return movable_of_object_; }

  BuiltWorld world;
  IsectorSet isectors;  ///< all that the commanded motions load
  IsectorSet support;   ///< TRIPOD alone, at the pose after the motion: Coverage::kPaper
  Stance stance;        ///< the same for Coverage::kExtended
  RigidBodies bodies;
  Disposal disposal;
  Task task;
  Scorer score;  ///< of the last mission, until the next one starts

 private:
  void ObeyOrders();
  void FollowBodies();

  const ModuleModel& module_;
  const RobotModel& robot_;
  int probe_;
  Rules rules_;
  StartPose start_;
  uint64_t seed_ = 0;
  CastMemory memory_;
  std::vector<int> movable_of_object_;
  std::vector<Eigen::Isometry3d> poses_;  ///< where the world has each movable ...
  std::vector<Eigen::Isometry3d> starts_;
  std::vector<char> hidden_;  ///< ... unless it meets nothing
};

}  // namespace eod::sim
