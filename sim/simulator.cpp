#include "sim/simulator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "sim/all_modules.h"
#include "sim/look_ahead.h"
#include "sim/stance/standing.h"

namespace eod::sim {
namespace {

/// The scenario's own module has its steps; any other one is free driving.
Scenario ScenarioIn(const ModuleModel& module, const Scenario& scenario) {
  if (module.id == scenario.module) return scenario;
  Scenario free_driving;
  free_driving.file = scenario.file;
  free_driving.module = module.id;
  return free_driving;
}

bool IsSame(TaskStatus a, const TaskStatus& b) {
  a.elapsed_s = b.elapsed_s;
  return a == b;
}

double SignedRate(const RobotModel& robot, const MotionDemand& demand, int positive, int negative) {
  return demand.rate[positive] * RatedSpeed(robot, positive, demand.speed_range) -
         demand.rate[negative] * RatedSpeed(robot, negative, demand.speed_range);
}

}  // namespace

Simulator::Place::Place(const RobotModel& robot, const WorldModel& all, const ModuleModel& model,
                        const Scenario& scenario, const SimulatorConfig& config)
    : module(&model),
      world(std::make_unique<BuiltWorld>(config.rules.module_masks ? model
                                                                   : WithAllModules(all, model))),
      isectors(robot, model.class_bit, config.coverage, config.rules),
      support(robot, model.class_bit, Coverage::kPaper,
              {.module_masks = config.rules.module_masks}),
      task(ScenarioIn(model, scenario), model) {}

Simulator::Simulator(const RobotModel& robot, const WorldModel& world, const Scenario& scenario,
                     const SimulatorConfig& config)
    : robot_(robot),
      scenario_(scenario),
      config_(config),
      dt_s_(ToSeconds(config.period)),
      alarm_rules_(config.exercise.tilt),
      start_asked_(config.start_mission) {
  using std::chrono::milliseconds;
  if (config.period < milliseconds(1) || config.period > milliseconds(20)) {
    throw std::runtime_error(
        fmt::format("step period {} ms, allowed 1 .. 20 ms", 1000 * ToSeconds(config.period)));
  }
  if (config.exercise.file.empty()) throw std::runtime_error("simulator: no rules were loaded");
  if (std::none_of(world.modules.begin(), world.modules.end(),
                   [&](const ModuleModel& module) { return module.id == scenario.module; })) {
    throw std::runtime_error(fmt::format("{}: module {} is not in {}", scenario.file.string(),
                                         scenario.module, world.file.string()));
  }
  for (const ModuleModel& module : world.modules) {
    places_.push_back(std::make_unique<Place>(robot, world, module, scenario, config));
  }
  result_.alarm_changes.reserve(16);
  // Every list grows to its full length now, so that no step has to allocate.
  for (const auto& place : places_) {
    place_ = place.get();
    StandAtStart();
    Cast(kAllMotions);
    response_.contacts.reserve(place->isectors.segments().size());
    response_.held.reserve(place->isectors.segments().size());
  }
  EnterModule(scenario.module);
}

const StepResult& Simulator::Step(TimePoint now, const OperatorCommand& command) {
  ++result_.step;
  result_.time = now;
  ObeyMenu(command);
  const Wish wish = paused_ ? Wish{} : WishOf(command, now, config_.command_timeout);
  const MotionSet limited = LimitedMotions(robot_, result_.state) & wish.demand.commanded;
  const uint32_t contacts_before = result_.contact_parts;

  Cast(wish.demand.commanded);
  Respond(robot_, result_.state, link_poses_, place_->isectors.segments(), wish.demand,
          {.dt_s = dt_s_, .with_factor = config_.rules.distance_factor}, response_);
  // A robot that stands still stands where it stood, to the last bit.
  if (Move(wish.demand, limited)) StandOnGround();
  Report(command, wish, limited);
  UpdateAlarms(wish.demand.commanded, limited);
  UpdateTask(contacts_before);
  return result_;
}

/// A menu command acts once, when it appears. A module that this world lacks is no reason to fail:
/// the mission starts where the robot is.
void Simulator::ObeyMenu(const OperatorCommand& command) {
  if (command.menu_command == last_menu_command_) return;
  last_menu_command_ = command.menu_command;
  switch (command.menu_command) {
    case kMenuStart:
      EnterModule(command.menu_module);
      start_asked_ = true;
      paused_ = false;
      break;
    case kMenuPause:
      paused_ = true;
      break;
    case kMenuResume:
      paused_ = false;
      break;
    case kMenuReset:
      EnterModule(place_->module->id);
      paused_ = false;
      break;
    case kMenuEnd:
      end_asked_ = true;
      paused_ = false;
      break;
    default:
      break;
  }
}

void Simulator::EnterModule(int id) {
  for (const auto& place : places_) {
    if (place->module->id != id) continue;
    place_ = place.get();
    place_->task.Reset();
    StandAtStart();
  }
}

void Simulator::StandAtStart() {
  result_.module = place_->module->id;
  result_.state = HomeState(robot_);
  result_.state.attitude = place_->module->start_attitude;
  result_.contact_parts = 0;
  response_.held.clear();
  LinkPoses(robot_, result_.state, link_poses_);
  StandOnGround();
}

void Simulator::Cast(MotionSet wanted) {
  place_->isectors.Cast(*place_->world, link_poses_, wanted | response_.Watched(), result_.step);
}

/// Returns whether the robot moved, or is falling.
bool Simulator::Move(const MotionDemand& wanted, MotionSet limited) {
  MotionDemand allowed = wanted;
  allowed.commanded &= ~(response_.blocked | limited);
  for (int motion = 0; motion < kMotionCount; ++motion) {
    if (!Contains(allowed.commanded, motion)) allowed.rate[motion] = 0;
  }
  allowed.left_hand_stopped = (allowed.commanded & response_.left_hand_blocked) != 0;
  allowed.right_hand_stopped = (allowed.commanded & response_.right_hand_blocked) != 0;
  const RobotState before = result_.state;
  result_.state = Advance(robot_, before, allowed, dt_s_);
  result_.speed = SignedRate(robot_, allowed, kDriveForward, kDriveReverse);
  result_.turn_rate = SignedRate(robot_, allowed, kTurnLeft, kTurnRight);
  if (result_.state == before) return before.fall_speed > 0;
  LinkPoses(robot_, result_.state, link_poses_);
  return true;
}

void Simulator::StandOnGround() {
  place_->support.Cast(*place_->world, link_poses_, 0, result_.step);
  result_.state = StandOn(place_->support.ground(), result_.state, dt_s_);
  LinkPoses(robot_, result_.state, link_poses_);
}

void Simulator::Report(const OperatorCommand& command, const Wish& wish, MotionSet limited) {
  result_.limit_flags = LimitFlags(robot_, result_.state);
  result_.contact_parts = response_.contact_parts;
  result_.command_sequence = command.sequence;
  result_.inhibited =
      (response_.blocked | limited | wish.refused | command.inhibited) & kAllMotions;
  result_.inhibit_reason = response_.blocked != 0       ? kReasonCollision
                           : limited != 0               ? kReasonJointLimit
                           : wish.reason != kReasonNone ? wish.reason
                                                        : command.inhibit_reason;
}

void Simulator::UpdateAlarms(MotionSet wanted, MotionSet limited) {
  AlarmInputs inputs;
  inputs.dt_s = dt_s_;
  inputs.contact_parts = response_.contact_parts;
  inputs.pushing = (wanted & response_.blocked) != 0;
  inputs.limit_flags = result_.limit_flags;
  for (int motion = 0; motion < kMotionCount; ++motion) {
    if (Contains(limited, motion)) inputs.driven_joints |= 1u << JointOf(robot_, motion).joint;
  }
  const Attitude& attitude = result_.state.attitude;
  inputs.tilt =
      std::acos(std::clamp(std::cos(attitude.pitch) * std::cos(attitude.roll), -1.0, 1.0));
  result_.alarm_changes.clear();
  alarm_rules_.Update(inputs, alarms_, result_.alarm_changes);
}

void Simulator::UpdateTask(uint32_t contacts_before) {
  const Ahead ahead = LookAhead(robot_, link_poses_, place_->isectors.segments());
  const int first = response_.first_contact;
  TaskInputs inputs;
  inputs.dt_s = dt_s_;
  inputs.state = &result_.state;
  inputs.speed = result_.speed;
  inputs.turn_rate = result_.turn_rate;
  inputs.started = std::exchange(start_asked_, false);
  inputs.ended = std::exchange(end_asked_, false);
  inputs.new_contact = (response_.contact_parts & ~contacts_before) != 0;
  inputs.in_contact = response_.contact_parts != 0;
  inputs.rolled_over = alarms_.IsActive(AlarmCode::kRollover);
  if (first >= 0) {
    inputs.contact_object =
        place_->world->ObjectName(place_->isectors.segments()[first].hit.object);
  }
  inputs.forward_clearance = ahead.clearance;
  inputs.forward_object = place_->world->ObjectName(ahead.object);
  const TaskStatus before = result_.task;
  // A pause stops the exercise's clock too.
  result_.task = paused_ ? place_->task.status() : place_->task.Advance(inputs);
  result_.task_changed = !IsSame(before, result_.task);
}

}  // namespace eod::sim
