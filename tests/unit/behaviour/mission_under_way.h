#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "sim/task/task.h"

namespace eod::sim {

/// A flat yard with a wall, a gate (driven through along X) and a board.
inline ModuleModel Flat() {
  ModuleModel module;
  module.id = 1;
  module.name = "flat";
  for (const char* name : {"wall", "gate_1", "board"}) {
    WorldObject object;
    object.name = name;
    module.objects.push_back(object);
  }
  module.objects[1].X_MO.translation() = Eigen::Vector3d(-4, 1.9, 0);
  return module;
}

/// A mission under way, fed by hand.
struct Mission {
  RobotState state;
  TaskInputs inputs;
  Task task;

  explicit Mission(std::vector<TaskStep> steps, double time_limit_s = 0,
                   const ModuleModel& module = Flat())
      : task(Make(std::move(steps), time_limit_s), module) {
    inputs.dt_s = 0.1;
    inputs.state = &state;
    inputs.forward_clearance = std::numeric_limits<double>::infinity();
    inputs.started = true;
    Step();
    inputs.started = false;
  }
  static Scenario Make(std::vector<TaskStep> steps, double time_limit_s) {
    Scenario scenario;
    scenario.steps = std::move(steps);
    scenario.time_limit_s = time_limit_s;
    return scenario;
  }
  TaskStatus Step() { return task.Advance(inputs); }
};

inline TaskStep StepOf(TaskStep::Kind kind, const std::string& object, double distance = 0,
                       double tolerance = 0) {
  TaskStep step;
  step.kind = kind;
  step.object = object;
  step.distance = distance;
  step.tolerance = tolerance;
  return step;
}

}  // namespace eod::sim
