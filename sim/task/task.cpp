#include "sim/task/task.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/disposal/charge.h"

namespace eod::sim {
namespace {

constexpr double kStillTime = 1.0;    // [s]
constexpr double kStillSpeed = 1e-3;  // [m/s] and [rad/s]

template <typename Named>
int IndexOf(const std::vector<Named>& list, const std::string& name) {
  const auto found = std::find_if(list.begin(), list.end(),
                                  [&name](const Named& one) { return one.name == name; });
  return found == list.end() ? -1 : static_cast<int>(found - list.begin());
}

bool IsStill(const TaskInputs& inputs) { return StandsStill(inputs.speed, inputs.turn_rate); }

bool IsNear(const Eigen::Vector3d& p_M, const TaskStep& step) {
  return std::hypot(p_M.x() - step.x, p_M.y() - step.y) <= step.tolerance;
}

bool IsInside(const VesselSpec& vessel, const Eigen::Vector3d& p_M) {
  const Eigen::Vector3d p_V = vessel.X_MV.inverse() * p_M;
  if (p_V.z() < vessel.net_z || p_V.z() > vessel.rim_z) return false;
  return IsWithinWalls(vessel, p_V);
}

bool IsInVessel(const VesselSpec& vessel, const TaskInputs& inputs) {
  const DisposalStatus& disposal = *inputs.disposal;
  const auto bomb = static_cast<size_t>(disposal.bomb_body);
  return disposal.bomb == BombState::kInCan && bomb < inputs.movables.size() &&
         IsInside(vessel, inputs.movables[bomb].translation());
}

bool IsDisrupted(int movable, const DisposalStatus& disposal) {
  return disposal.bomb == BombState::kDisrupted && (movable < 0 || disposal.bomb_body == movable);
}

}  // namespace

bool StandsStill(double speed, double turn_rate) {
  return std::abs(speed) < kStillSpeed && std::abs(turn_rate) < kStillSpeed;
}

Task::Task(const Scenario& scenario, const ModuleModel& module, const CriticalRules& critical)
    : critical_(scenario, module, critical),
      critical_reasons_(scenario.critical),
      time_limit_s_(scenario.time_limit_s) {
  for (const TaskStep& spec : scenario.steps) steps_.push_back(MakeStep(spec, scenario, module));
  status_.steps = static_cast<int>(steps_.size());
}

Task::Step Task::MakeStep(const TaskStep& spec, const Scenario& scenario,
                          const ModuleModel& module) {
  Step step;
  step.spec = spec;
  const bool needs_vessel = spec.kind == TaskStep::Kind::kPlaceInVessel;
  const bool needs_movable = spec.kind == TaskStep::Kind::kGrasp ||
                             spec.kind == TaskStep::Kind::kLift ||
                             spec.kind == TaskStep::Kind::kDisrupt;
  if (spec.object.empty()) return step;
  const auto fail = [&](std::string_view what) {
    throw std::runtime_error(fmt::format("{}{}: object '{}' is {} module {} ({})",
                                         scenario.file.string(),
                                         spec.line > 0 ? fmt::format(":{}", spec.line) : "",
                                         spec.object, what, module.id, module.name));
  };
  const int object = IndexOf(module.objects, spec.object);
  const int vessel = IndexOf(module.vessels, spec.object);
  step.movable = IndexOf(module.movables, spec.object);
  if (object < 0 && step.movable < 0) fail("not in");
  if (needs_movable && step.movable < 0) fail("no movable of");
  if (needs_vessel && vessel < 0) fail("no vessel of");
  step.X_MO = step.movable >= 0 ? module.movables[step.movable].X_MO : module.objects[object].X_MO;
  if (vessel >= 0) step.vessel = module.vessels[vessel];
  return step;
}

const TaskStatus& Task::Advance(const TaskInputs& inputs) {
  if (inputs.started) Start(inputs);
  if (status_.state != MissionState::kRun) return status_;
  if (inputs.ended) {
    status_.state = MissionState::kAbort;
    return status_;
  }

  // Start itself is moment 0: the first step of the mission has elapsed one later.
  if (!inputs.started) ++elapsed_steps_;
  status_.elapsed_s = static_cast<double>(elapsed_steps_) * inputs.dt_s;
  if (inputs.new_contact) ++status_.collisions;
  WatchGrasp(inputs);
  if (status_.step < status_.steps && IsComplete(steps_[status_.step], inputs)) {
    CompleteStep(*inputs.state);
  }
  last_position_ = inputs.state->position;

  status_.fail_reason = Failure(inputs);
  if (status_.fail_reason != FailReason::kNone) {
    status_.state = MissionState::kFail;
  } else if (status_.step == status_.steps) {
    status_.state = MissionState::kSuccess;
  }
  return status_;
}

/// A charge that goes off spoils even the last step; nothing else does.
FailReason Task::Failure(const TaskInputs& inputs) {
  if (critical_.HasExploded(inputs)) return FailReason::kExploded;
  if (status_.step == status_.steps) return FailReason::kNone;
  const FailReason found = critical_.Look(inputs);
  if (found != FailReason::kNone) return found;
  if (IsOutOfTurn(inputs)) return FailReason::kWrongOrder;
  const bool late = time_limit_s_ > 0 && status_.elapsed_s >= time_limit_s_;
  return late ? FailReason::kTimeOut : FailReason::kNone;
}

/// Whether a strict step behind the current one is done already.
bool Task::IsOutOfTurn(const TaskInputs& inputs) {
  if (!Contains(critical_reasons_, FailReason::kWrongOrder)) return false;
  return std::any_of(steps_.begin() + status_.step + 1, steps_.end(), [&](const Step& step) {
    return step.spec.strict && IsComplete(step, inputs);
  });
}

std::optional<InspectedObject> Task::inspected() const {
  if (status_.state != MissionState::kRun || status_.step >= status_.steps) return {};
  const Step& step = steps_[status_.step];
  if (step.spec.kind != TaskStep::Kind::kInspect) return {};
  return InspectedObject{.step = &step.spec, .movable = step.movable, .X_MO = step.X_MO};
}

const std::string& Task::step_text() const {
  static const std::string kNothing;
  const bool running = status_.state == MissionState::kRun && status_.step < status_.steps;
  return running ? steps_[status_.step].spec.text : kNothing;
}

void Task::Reset() {
  status_ = {.steps = static_cast<int>(steps_.size())};
  elapsed_steps_ = 0;
  still_steps_ = 0;
  held_ = -1;
}

void Task::Start(const TaskInputs& inputs) {
  Reset();
  // A scenario without steps is free driving: there is nothing to run or to pass.
  if (steps_.empty()) return;
  status_.state = MissionState::kRun;
  mark_ = inputs.state->position;
  last_position_ = inputs.state->position;
  critical_.Start(inputs);
}

/// Remembers how high a thing was when it was grasped.
void Task::WatchGrasp(const TaskInputs& inputs) {
  const int held = inputs.disposal == nullptr ? -1 : inputs.disposal->held_body;
  const bool known = held >= 0 && static_cast<size_t>(held) < inputs.movables.size();
  if (held != held_ && known) grasp_height_ = inputs.movables[held].translation().z();
  held_ = known ? held : -1;
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
      return IsNear(p_M, spec);
    case TaskStep::Kind::kGrasp:
      return held_ >= 0 && held_ == step.movable;
    case TaskStep::Kind::kLift:
      return IsLifted(step, inputs);
    case TaskStep::Kind::kPlaceInVessel:
      return inputs.disposal != nullptr && IsInVessel(step.vessel, inputs);
    case TaskStep::Kind::kDisrupt:
      return inputs.disposal != nullptr && IsDisrupted(step.movable, *inputs.disposal);
    case TaskStep::Kind::kClimb:
      return p_M.z() >= spec.distance && IsNear(p_M, spec);
    case TaskStep::Kind::kHoldStill:
      return HasHeldStill(spec, inputs);
    case TaskStep::Kind::kInspect:
      return HasInspected(spec, inputs);
    case TaskStep::Kind::kRetreat: {
      const bool moved =
          step.movable >= 0 && static_cast<size_t>(step.movable) < inputs.movables.size();
      const Eigen::Isometry3d& X_MO = moved ? inputs.movables[step.movable] : step.X_MO;
      return (p_M - X_MO.translation()).head<2>().norm() >= spec.distance;
    }
  }
  return false;
}

bool Task::IsLifted(const Step& step, const TaskInputs& inputs) const {
  if (held_ < 0 || (step.movable >= 0 && held_ != step.movable)) return false;
  return inputs.movables[held_].translation().z() - grasp_height_ >= step.spec.distance;
}

/// The gate's posts stand along Y of its frame: passed when the way of this step crosses x = 0
/// between them, from either side.
bool Task::HasPassed(const Step& gate, const Eigen::Vector3d& p_M) const {
  const Eigen::Isometry3d X_OM = gate.X_MO.inverse();
  const Eigen::Vector3d before = X_OM * last_position_;
  const Eigen::Vector3d after = X_OM * p_M;
  if ((before.x() > 0) == (after.x() > 0)) return false;
  const double share = before.x() / (before.x() - after.x());
  const double y = before.y() + share * (after.y() - before.y());
  return std::abs(y) <= gate.spec.distance / 2;
}

bool Task::HasStopped(const TaskStep& step, const TaskInputs& inputs) {
  const bool on_mark = inputs.forward_object == step.object &&
                       std::abs(inputs.forward_clearance - step.distance) <= step.tolerance;
  still_steps_ = IsStill(inputs) && on_mark ? still_steps_ + 1 : 0;
  return still_steps_ * inputs.dt_s >= kStillTime;
}

bool Task::HasHeldStill(const TaskStep& step, const TaskInputs& inputs) {
  const bool held = IsStill(inputs) && TiltOf(inputs.state->attitude) >= step.tilt;
  still_steps_ = held ? still_steps_ + 1 : 0;
  return held && still_steps_ * inputs.dt_s >= step.time;
}

bool Task::HasInspected(const TaskStep& step, const TaskInputs& inputs) {
  still_steps_ = inputs.sees_object ? still_steps_ + 1 : 0;
  return inputs.sees_object && still_steps_ * inputs.dt_s >= step.time;
}

void Task::CompleteStep(const RobotState& state) {
  ++status_.step;
  still_steps_ = 0;
  mark_ = state.position;
}

}  // namespace eod::sim
