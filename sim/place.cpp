#include "sim/place.h"

#include "sim/all_modules.h"
#include "sim/simulator.h"

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

}  // namespace

Place::Place(RobotModel& robot, int probe, const WorldModel& all, const ModuleModel& model,
             const Scenario& scenario, const SimulatorConfig& config)
    : world(config.rules.module_masks ? model : WithAllModules(all, model)),
      isectors(robot, model.class_bit, config.coverage, config.rules),
      support(robot, model.class_bit, Coverage::kPaper,
              {.module_masks = config.rules.module_masks}),
      stance(robot, config.rules.module_masks ? model.class_bit : kAnyModule),
      bodies(model, robot),
      disposal(robot, probe, model, config.exercise, config.grasp,
               static_cast<uint64_t>(scenario.seed)),
      task(ScenarioIn(model, scenario), model, config.exercise.score),
      module_(model),
      probe_(probe) {
  hidden_.assign(model.movables.size(), 0);
  const int movables = static_cast<int>(model.movables.size());
  for (int object = 0; object < world.ObjectOfMovable(movables); ++object) {
    movable_of_object_.push_back(world.MovableOfObject(object));
  }
  for (const MovableObject& movable : model.movables) poses_.push_back(movable.X_MO);
}

void Place::Reset() {
  bodies.Reset();
  disposal.Reset();
  isectors.Reload(probe_);
  task.Reset();
  stance.Reset();
  FollowBodies();
}

void Place::MoveBodies(double dt_s, std::span<const Eigen::Isometry3d> X_ML) {
  ObeyOrders();
  bodies.Step(dt_s, X_ML);
  FollowBodies();
}

void Place::ObeyOrders() {
  const DisposalOrders& orders = disposal.orders();
  if (orders.hold >= 0) bodies.Hold(orders.hold);
  if (orders.move_held >= 0) bodies.MoveHeld(orders.move_held, orders.X_MO);
  if (orders.release >= 0) bodies.Release(orders.release);
  if (orders.remove >= 0) bodies.Remove(orders.remove);
  if (orders.push >= 0) bodies.Push(orders.push, orders.impulse_M, orders.p_M);
  if (orders.reload_isector >= 0) isectors.Reload(orders.reload_isector);
}

void Place::FollowBodies() {
  const std::span<const BodyState> states = bodies.states();
  for (size_t i = 0; i < states.size(); ++i) {
    const int body = static_cast<int>(i), object = world.ObjectOfMovable(body);
    const bool hide = states[i].is_gone || disposal.Ignores(body);
    if (hide && hidden_[i] == 0) world.Hide(object);
    const bool moved = poses_[i].matrix() != states[i].X_MO.matrix();
    if (!hide && (moved || hidden_[i] != 0)) world.Move(object, states[i].X_MO);
    poses_[i] = states[i].X_MO;
    hidden_[i] = hide ? 1 : 0;
  }
}

}  // namespace eod::sim
