#include "sim/place.h"

#include <algorithm>

#include "sim/all_modules.h"
#include "sim/simulator.h"

namespace eod::sim {

Place::Place(RobotModel& robot, int probe, const WorldModel& all, const ModuleModel& model,
             const SimulatorConfig& config)
    : world(config.rules.module_masks ? model : WithAllModules(all, model)),
      isectors(robot, model.class_bit, config.coverage, config.rules),
      support(robot, model.class_bit, Coverage::kPaper,
              {.module_masks = config.rules.module_masks}),
      stance(robot, config.rules.module_masks ? model.class_bit : kAnyModule),
      bodies(model, robot),
      disposal(robot, probe, model, config.exercise, config.grasp),
      task({}, model),
      score({}, model, config.exercise),
      module_(model),
      robot_(robot),
      probe_(probe),
      rules_(config.exercise) {
  hidden_.assign(model.movables.size(), 0);
  const int movables = static_cast<int>(model.movables.size());
  for (int object = 0; object < world.ObjectOfMovable(movables); ++object) {
    movable_of_object_.push_back(world.MovableOfObject(object));
  }
  for (const MovableObject& movable : model.movables) poses_.push_back(movable.X_MO);
}

void Place::Load(const Scenario& scenario) {
  start_ = StartOf(scenario, module_);
  seed_ = static_cast<uint64_t>(scenario.seed);
  for (size_t i = 0; i < module_.movables.size(); ++i) {
    const MovableObject& movable = module_.movables[i];
    const auto place =
        std::find_if(scenario.places.begin(), scenario.places.end(),
                     [&](const Placement& one) { return one.object == movable.name; });
    std::optional<Eigen::Isometry3d> X_MO;
    if (place != scenario.places.end()) X_MO = StartOf(movable, *place);
    bodies.SetStart(static_cast<int>(i), X_MO);
  }
  task = Task(scenario, module_, rules_.critical);
  score = Scorer(scenario, module_, rules_);
  Restart();
}

StartPose Place::Start() {
  if (!start_.is_given) return start_;
  SegmentQuery query;
  query.start = start_.p_M + robot_.step_up_limit * Eigen::Vector3d::UnitZ();
  query.direction = -Eigen::Vector3d::UnitZ();
  query.length = robot_.step_up_limit + robot_.fall_search;
  query.class_mask = module_.class_bit | kClampProxy;
  query.hit_rule = HitRule::kNearest;
  SegmentHit hit;
  world.Cast({&query, 1}, {&hit, 1}, memory_);
  StartPose on_ground = start_;
  if (hit.hit) on_ground.p_M.z() = hit.point.z();
  return on_ground;
}

void Place::Restart() {
  bodies.Reset();
  disposal.Reset(seed_);
  isectors.Reload(probe_);
  task.Reset();
  stance.Reset();
  FollowBodies();
  starts_ = poses_;
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
