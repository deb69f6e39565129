#pragma once

#include <chrono>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "sim/response/response.h"
#include "sim/robot/robot_model.h"
#include "sim/world/analytic_world.h"
#include "sim/world/world_model.h"

namespace eod::sim {

inline constexpr double kDegree = std::numbers::pi / 180;
inline const std::filesystem::path kData = EOD_DATA_DIR;

/// The robot that the product ships.
inline const RobotModel& TheRobot() {
  static const RobotModel robot = LoadRobot(kData / "sim/robots/eod_robot.sdf");
  return robot;
}

/// The same without accelerations: it moves at full rate from the first step to the last.
inline const RobotModel& TheSharpRobot() {
  static const RobotModel robot = [] {
    RobotModel sharp = TheRobot();
    sharp.drive_acceleration = sharp.turn_acceleration = kAtOnce;
    for (JointSpec& joint : sharp.joints) joint.acceleration = kAtOnce;
    return sharp;
  }();
  return robot;
}

/// Only the isectors of these names: for tests of one line among many.
inline RobotModel WithIsectors(RobotModel robot, const std::vector<std::string>& names) {
  std::erase_if(robot.isectors, [&](const IsectorSpec& isector) {
    return std::find(names.begin(), names.end(), isector.name) == names.end();
  });
  return robot;
}

/// Standing at the origin with both flippers level, so that the small wheels go first.
inline RobotState LevelFlippers(const RobotModel& robot) {
  RobotState state = HomeState(robot);
  state.joint[kFrontFlipper] = 0;
  state.joint[kRearFlipper] = 0;
  return state;
}

inline MotionDemand DemandFor(std::initializer_list<int> motions, double rate = 1,
                              int speed_range = 1) {
  MotionDemand demand;
  demand.speed_range = speed_range;
  for (const int motion : motions) {
    demand.rate[motion] = rate;
    demand.commanded |= SetOf(motion);
  }
  return demand;
}

/// A wall beside or before the robot that reaches everywhere.
inline void AddWall(AnalyticWorld& world, const Eigen::Vector3d& point,
                    const Eigen::Vector3d& n_M) {
  world.AddPlane("wall", kModuleFlat | kBumpProxy, point, n_M.normalized());
}

/// Motion, isectors and response alone: no ground, no task.
struct Yard {
  RobotModel robot;
  RobotState state;
  AnalyticWorld world;
  Response response;
  DistanceLaw law{.dt_s = 0.004};
  IsectorSet isectors;
  std::vector<Eigen::Isometry3d> X_ML;

  explicit Yard(const RobotModel& model, const IsectorRules& rules = {})
      : robot(model),
        state(LevelFlippers(model)),
        isectors(robot, kModuleFlat, Coverage::kExtended, rules) {}
  Yard(const Yard&) = delete;
  Yard& operator=(const Yard&) = delete;

  void Step(const MotionDemand& wanted) {
    LinkPoses(robot, state, X_ML);
    isectors.Cast(world, X_ML, wanted.commanded | response.Watched());
    Respond(robot, state, X_ML, isectors.segments(), wanted, law, response);
    MotionDemand allowed = wanted;
    allowed.commanded &= ~response.blocked;
    allowed.left_hand_stopped = (allowed.commanded & response.left_hand_blocked) != 0;
    allowed.right_hand_stopped = (allowed.commanded & response.right_hand_blocked) != 0;
    for (int motion = 0; motion < kMotionCount; ++motion) {
      if (!Contains(allowed.commanded, motion)) allowed.rate[motion] = 0;
    }
    state = Advance(robot, state, allowed, law.dt_s);
  }

  void Step(const MotionDemand& wanted, int times) {
    for (int i = 0; i < times; ++i) Step(wanted);
  }
};

}  // namespace eod::sim
