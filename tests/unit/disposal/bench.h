#pragma once

#include <memory>
#include <vector>

#include "sim/disposal/charge.h"
#include "sim/disposal/disposal.h"
#include "tests/unit/behaviour/fixture.h"

namespace eod::sim {

inline constexpr double kStep = 0.004;                // [s]
inline constexpr double kFingerMiddle = 0.15 + 0.08;  // [m] along Y of the gripper

inline const Rules& TheRules() {
  static const Rules rules = LoadRules(kData / "sim/rules/eod_rules.toml");
  return rules;
}

/// Cylinders of the bomb module: radius and half height [m], mass [kg].
inline MovableObject Cylinder(double radius, double half_height, double mass) {
  MovableObject charge;
  charge.name = "charge";
  charge.object_class = kModuleBomb | kBombObject | kBumpProxy;
  charge.mass = mass;
  charge.explosive = ExplosiveSpec{radius, half_height};
  return charge;
}
inline MovableObject CylinderM() { return Cylinder(0.06, 0.12, 3); }

inline ModuleModel BombModule(std::vector<MovableObject> movables) {
  ModuleModel module;
  module.id = 3;
  module.class_bit = kModuleBomb;
  module.movables = std::move(movables);
  return module;
}

/// Hand level at table height, arm stretched forward.
inline RobotState TablePose() {
  RobotState state = HomeState(TheSharpRobot());
  state.joint[kBigArm] = 54.3 * kDegree;
  state.joint[kSmallArm] = 99.3 * kDegree;
  state.joint[kWrist] = 26.4 * kDegree;
  return state;
}

/// A robot, charges as exact cylinders, and the rules. Bodies stay where a test puts them, and
/// follow the hand while they are held.
class Bench {
 public:
  explicit Bench(const ModuleModel& bomb_module = BombModule({CylinderM()}),
                 GraspMode mode = GraspMode::kGuarded)
      : robot(TheSharpRobot()),
        module(bomb_module),
        probe(AppendHeldProbe(robot)),
        state(TablePose()),
        isectors(robot, kModuleBomb),
        dut(robot, probe, module, TheRules(), mode) {
    for (size_t i = 0; i < module.movables.size(); ++i) {
      const MovableObject& movable = module.movables[i];
      bodies.emplace_back();
      bodies.back().X_MO = movable.X_MO;
      objects.push_back(world.AddShape(
          movable.name, movable.object_class, movable.X_MO,
          Shape::Cylinder(movable.explosive->radius, 2 * movable.explosive->half_height)));
      movable_of_object.push_back(static_cast<int>(i));
    }
    LinkPoses(robot, state, X_ML);
  }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  const Eigen::Isometry3d& X_MG() const { return X_ML[FindLink(robot, "gripper")]; }

  void Open(double left, double right) {
    state.left_opening = left;
    state.right_opening = right;
    state.joint[kGripperOpening] = (left + right) / 2;
    LinkPoses(robot, state, X_ML);
  }
  void Open(double both) { Open(both, both); }

  /// `right` of the middle between the fingers and `ahead` of the middle along them [m], turned by
  /// `turn` in the gripper's frame.
  void PlaceInHand(double right, double ahead,
                   const Eigen::Quaterniond& turn = Eigen::Quaterniond::Identity(), int body = 0) {
    bodies[body].X_MO = X_MG() * Eigen::Translation3d(right, kFingerMiddle + ahead, 0) * turn;
  }

  /// Lines and judgement at the pose, for a demand.
  void Look(const MotionDemand& demand) {
    for (size_t i = 0; i < bodies.size(); ++i) {
      const Eigen::Isometry3d nowhere(Eigen::Translation3d(0, 0, -1000));
      world.Move(objects[i], dut.Ignores(static_cast<int>(i)) ? nowhere : bodies[i].X_MO);
    }
    LinkPoses(robot, state, X_ML);
    isectors.Cast(world, X_ML, demand.commanded | response.Watched());
    Respond(robot, state, X_ML, isectors.segments(), demand, {.dt_s = kStep}, response);
  }

  HandLines Lines() const {
    return HandLayout(robot).Read(isectors.segments(), response.contacts, module,
                                  movable_of_object);
  }

  /// Range of a line of that name; negative if it meets nothing.
  double Range(const std::string& name) const {
    for (const CastSegment& cast : isectors.segments()) {
      if (robot.isectors[cast.isector].segments[cast.segment].name != name) continue;
      return cast.hit.hit ? cast.hit.range : -1;
    }
    return -2;
  }

  void Step(const MotionDemand& demand) {
    Look(demand);
    verdict = dut.Judge({.dt_s = kStep,
                         .state = &state,
                         .X_ML = X_ML,
                         .segments = isectors.segments(),
                         .demand = &demand,
                         .bodies = bodies,
                         .movable_of_object = movable_of_object,
                         .payload = payload},
                        response);
    Move(demand);
    dut.Advance({.dt_s = kStep,
                 .step = ++step,
                 .state = &state,
                 .X_ML = X_ML,
                 .bodies = bodies,
                 .movable_of_object = movable_of_object,
                 .world = &world,
                 .panel = panel,
                 .robot_is_still = demand.commanded == 0,
                 .rolled_over = rolled_over});
    Obey();
  }
  void Step(const MotionDemand& demand, int times) {
    for (int i = 0; i < times; ++i) Step(demand);
  }
  /// Until something is held, at most a while.
  bool CloseUntilGrasped(int most = 1000) {
    for (int i = 0; i < most && dut.status().held_body < 0; ++i) Step(DemandFor({kGripperClose}));
    return dut.status().held_body >= 0;
  }

  RobotModel robot;
  ModuleModel module;
  int probe;
  RobotState state;
  AnalyticWorld world;
  std::vector<int> objects, movable_of_object;
  std::vector<BodyState> bodies;
  IsectorSet isectors;
  Response response;
  MotionVerdict verdict;
  Disposal dut;
  std::vector<Eigen::Isometry3d> X_ML;
  FirePanel panel;
  double payload = 10;  // [kg]
  bool rolled_over = false;
  int64_t step = 0;
  int released = -1, removed = -1;

 private:
  void Move(const MotionDemand& demand) {
    MotionDemand allowed = demand;
    allowed.commanded &= ~(response.blocked & ~verdict.let_through);
    allowed.left_hand_stopped = (allowed.commanded & response.left_hand_blocked) != 0;
    allowed.right_hand_stopped = (allowed.commanded & response.right_hand_blocked) != 0;
    if (Contains(allowed.commanded, kGripperClose)) {
      allowed.left_hand_stopped |= verdict.left_hand_stopped;
      allowed.right_hand_stopped |= verdict.right_hand_stopped;
    }
    for (int motion = 0; motion < kMotionCount; ++motion) {
      double& rate = allowed.rate[motion];
      if (!Contains(allowed.commanded, motion)) rate = 0;
      if (Contains(verdict.let_through, motion)) rate = std::min(rate, verdict.most[motion]);
    }
    state = Advance(robot, state, allowed, kStep);
    LinkPoses(robot, state, X_ML);
  }

  void Obey() {
    const DisposalOrders& orders = dut.orders();
    if (orders.reload_isector >= 0) isectors.Reload(orders.reload_isector);
    if (orders.hold >= 0) bodies[orders.hold].is_held = true;
    if (orders.move_held >= 0) {
      bodies[orders.move_held].X_MO = orders.X_MO;
      bodies[orders.move_held].touches_ground = false;
    }
    if (orders.release >= 0) bodies[released = orders.release].is_held = false;
    if (orders.remove >= 0) bodies[removed = orders.remove].is_gone = true;
  }
};

}  // namespace eod::sim
