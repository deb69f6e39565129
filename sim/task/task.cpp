#include "sim/task/task.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace eod::sim {
namespace {

constexpr double kCollisionPenalty = 2;  // points, 4.2 of the design
constexpr double kStillTime = 1.0;       // [s]
constexpr double kStillSpeed = 1e-3;     // [m/s] and [rad/s]

const WorldObject& FindObject(const Scenario& scenario, const ModuleModel& module,
                              const std::string& name) {
  for (const WorldObject& object : module.objects) {
    if (object.name == name) return object;
  }
  throw std::runtime_error(fmt::format("{}: object '{}' is not in module {} ({})",
                                       scenario.file.string(), name, module.id, module.name));
}

}  // namespace

Task::Task(const Scenario& scenario, const ModuleModel& module)
    : time_limit_s_(scenario.time_limit_s) {
  for (const TaskStep& spec : scenario.steps) {
    Step step{.spec = spec};
    if (!spec.object.empty()) {
      step.X_OM = FindObject(scenario, module, spec.object).X_MO.inverse();
    }
    steps_.push_back(step);
  }
  status_.steps = static_cast<int>(steps_.size());
}

const TaskStatus& Task::Advance(const TaskInputs& inputs) {
  if (inputs.started) Start(*inputs.state);
  if (status_.state != MissionState::kRun) return status_;
  if (inputs.ended) {
    status_.state = MissionState::kAbort;
    return status_;
  }

  // Start itself is moment 0: the first step of the mission has elapsed one later.
  if (!inputs.started) ++elapsed_steps_;
  status_.elapsed_s = static_cast<double>(elapsed_steps_) * inputs.dt_s;
  if (inputs.new_contact) CountCollision(inputs);
  if (status_.step < status_.steps && IsComplete(steps_[status_.step], inputs)) {
    CompleteStep(*inputs.state);
  }
  status_.score = Score();
  last_position_ = inputs.state->position;

  if (status_.step == status_.steps) {
    status_.state = MissionState::kSuccess;
  } else if (inputs.rolled_over) {
    status_.state = MissionState::kFail;
    status_.fail_reason = FailReason::kRollover;
  } else if (time_limit_s_ > 0 && status_.elapsed_s >= time_limit_s_) {
    status_.state = MissionState::kFail;
    status_.fail_reason = FailReason::kTimeOut;
  }
  return status_;
}

const std::string& Task::step_text() const {
  static const std::string kNothing;
  const bool running = status_.state == MissionState::kRun && status_.step < status_.steps;
  return running ? steps_[status_.step].spec.text : kNothing;
}

void Task::Reset() {
  status_ = {.steps = static_cast<int>(steps_.size())};
  elapsed_steps_ = 0;
  asked_collisions_ = 0;
  still_steps_ = 0;
}

void Task::Start(const RobotState& state) {
  Reset();
  // A scenario without steps is free driving: there is nothing to run or to pass.
  if (steps_.empty()) return;
  status_.state = MissionState::kRun;
  mark_ = state.position;
  last_position_ = state.position;
}

bool Task::IsComplete(const Step& step, const TaskInputs& inputs) {
  const TaskStep& spec = step.spec;
  const Eigen::Vector3d& p_M = inputs.state->position;
  switch (spec.kind) {
    case TaskStep::Kind::kContact:
      return inputs.in_contact && (spec.object.empty() || inputs.contact_object == spec.object);
    case TaskStep::Kind::kClear:
      return !inputs.in_contact && (p_M - mark_).norm() >= spec.distance;
    case TaskStep::Kind::kPassGate:
      return HasPassed(step, p_M);
    case TaskStep::Kind::kStopAt:
      return HasStopped(spec, inputs);
    case TaskStep::Kind::kReach:
      return std::hypot(p_M.x() - spec.x, p_M.y() - spec.y) <= spec.tolerance;
  }
  return false;
}

/// The gate's posts stand along Y of its frame: passed when the way of this step crosses x = 0
/// between them, from either side.
bool Task::HasPassed(const Step& gate, const Eigen::Vector3d& p_M) {
  const Eigen::Vector3d before = gate.X_OM * last_position_;
  const Eigen::Vector3d after = gate.X_OM * p_M;
  if ((before.x() > 0) == (after.x() > 0)) return false;
  const double share = before.x() / (before.x() - after.x());
  const double y = before.y() + share * (after.y() - before.y());
  return std::abs(y) <= gate.spec.distance / 2;
}

bool Task::HasStopped(const TaskStep& step, const TaskInputs& inputs) {
  const bool still =
      std::abs(inputs.speed) < kStillSpeed && std::abs(inputs.turn_rate) < kStillSpeed;
  const bool on_mark = inputs.forward_object == step.object &&
                       std::abs(inputs.forward_clearance - step.distance) <= step.tolerance;
  still_steps_ = still && on_mark ? still_steps_ + 1 : 0;
  return still_steps_ * inputs.dt_s >= kStillTime;
}

/// A step may ask for a collision; any other one costs.
void Task::CountCollision(const TaskInputs& inputs) {
  ++status_.collisions;
  if (status_.step >= status_.steps) return;
  const TaskStep& spec = steps_[status_.step].spec;
  const bool asked = spec.kind == TaskStep::Kind::kContact &&
                     (spec.object.empty() || spec.object == inputs.contact_object);
  if (asked) ++asked_collisions_;
}

void Task::CompleteStep(const RobotState& state) {
  ++status_.step;
  still_steps_ = 0;
  mark_ = state.position;
}

double Task::Score() const {
  double all = 0;
  double done = 0;
  for (int i = 0; i < status_.steps; ++i) {
    all += steps_[i].spec.weight;
    if (i < status_.step) done += steps_[i].spec.weight;
  }
  const double penalty = kCollisionPenalty * (status_.collisions - asked_collisions_);
  return all > 0 ? std::max(0.0, 100 * done / all - penalty) : 0;
}

}  // namespace eod::sim
