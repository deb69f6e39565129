#include <cmath>
#include <cstring>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/world/built_world.h"
#include "tests/unit/sim/bodies_scene.h"

namespace eod::sim {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr uint32_t BitOf(Part part) { return 1u << static_cast<int>(part); }

/// A robot of one box, 1 m wide and long, that drives along +Y on flat ground.
class Pusher {
 public:
  static constexpr double kLength = 1, kHeight = 0.4;

  explicit Pusher(const ModuleModel& module)
      : robot_(BoxRobot({1, kLength, kHeight})), dut(module, robot_) {}
  /// `front` is the y of its front face [m].
  void StandAt(double front) {
    const std::vector<Isometry3d> X = {At(0, front - kLength / 2, kHeight / 2 + 0.02)};
    dut.Step(kDt, X);
  }
  void Drive(double from, double to, double speed) {
    const int steps = static_cast<int>(std::lround(std::abs(to - from) / (speed * kDt)));
    for (int i = 0; i <= steps; ++i) StandAt(from + (to - from) * i / steps);
  }
  void Stand(double front, double seconds) {
    for (int i = 0; i < seconds / kDt; ++i) StandAt(front);
  }
  const BodyState& state(size_t body = 0) const { return dut.states()[body]; }

 private:
  RobotModel robot_;

 public:
  RigidBodies dut;
};

TEST(RigidBodiesAndRobot, BoxIsPushedAndStaysWhereItIsLeft) {
  const double half = 0.15, way = 0.5;
  ModuleModel module = GroundOf(20);
  AddMovable(module, Shape::Box(Vector3d::Constant(2 * half)), 4, At(0.1, half, half));
  Pusher scene(module);
  scene.Drive(-0.5, 0, 0.3);
  EXPECT_NEAR(scene.state().X_MO.translation().y(), half, 1e-3) << "touched, not moved";
  scene.Drive(0, way, 0.3);
  EXPECT_EQ(scene.state().touched_by, BitOf(Part::kChassis));
  EXPECT_TRUE(scene.state().touches_ground);
  EXPECT_NEAR(scene.state().v_M.y(), 0.3, 0.02) << "it has the robot's speed";
  scene.Stand(way, 4);
  // It slides on by v^2 / (2 mu g) at most.
  const double slide = 0.3 * 0.3 / (2 * kFriction * 9.81);
  const double y = scene.state().X_MO.translation().y();
  EXPECT_GE(y, way + half - 1e-3);
  EXPECT_LE(y, way + half + slide + 2e-3);
  EXPECT_FALSE(scene.state().is_moving);
  const Isometry3d left = scene.state().X_MO;
  scene.Drive(way, -1, 0.5);
  scene.Stand(-1, 5);
  EXPECT_LT((scene.state().X_MO.translation() - left.translation()).norm(), 0.2e-3);
  EXPECT_EQ(scene.state().touched_by, 0u);
}

TEST(RigidBodiesAndRobot, TallChargeIsToppledByAHighPush) {
  ModuleModel module = GroundOf(20);
  AddStandingCharge(module, kLargeCharge, 0, kLargeCharge.radius);
  RobotModel bar;  // 0.25 m above the ground
  bar.links.push_back({});
  bar.links[0].name = "chassis";
  bar.links[0].solids.push_back({.shape = Shape::Box({1, 0.04, 0.04})});
  RigidBodies dut(module, bar);
  for (int i = 0; i < 1000; ++i) {
    const std::vector<Isometry3d> X = {At(0, -0.1 + 0.1 * kDt * i, 0.25)};
    dut.Step(kDt, X);
  }
  EXPECT_GT(TiltOf(dut.states()[0]), 1);
}

TEST(RigidBodiesAndRobot, JumpOfTheRobotWhileAllRestsIsNoBlow) {
  ModuleModel module = GroundOf(20);
  AddMovable(module, Shape::Box({0.3, 0.3, 0.3}), 4, At(0, 0.15, 0.15));
  Pusher scene(module);
  scene.Drive(-5, -4.5, 0.5);
  scene.Drive(-0.011, -0.01, 0.1);  // next to it at once
  scene.Stand(-0.01, 3);
  EXPECT_NEAR(scene.state().X_MO.translation().y(), 0.15, 1e-3);
}

TEST(RigidBodiesAndRobot, HeldBodyFollowsExactlyAndGoesThroughTheRobot) {
  ModuleModel module = GroundOf(20);
  AddStandingCharge(module, kMiddleCharge, 0, 1);
  Pusher scene(module);
  scene.StandAt(0);
  scene.dut.Hold(0);
  for (int i = 0; i < 200; ++i) {
    const Isometry3d X_MO = At(0, 1 - 0.005 * i, 0.3) * AngleAxisd(0.01 * i, Vector3d::UnitX());
    scene.dut.MoveHeld(0, X_MO);
    scene.StandAt(0);
    EXPECT_EQ(scene.state().X_MO.matrix(), X_MO.matrix());
    EXPECT_TRUE(scene.state().is_held);
    EXPECT_EQ(scene.state().touched_by, 0u);
  }
}

TEST(RigidBodiesAndRobot, HeldBodyPushesOthers) {
  ModuleModel module = GroundOf(20);
  AddCharge(module, kMiddleCharge, At(0, 1, 0.2));
  AddMovable(module, Shape::Box({0.3, 0.3, 0.3}), 2, At(0, 1.5, 0.15));
  Pusher scene(module);
  scene.StandAt(-3);
  scene.dut.Hold(0);
  for (int i = 0; i < 500; ++i) {
    scene.dut.MoveHeld(0, At(0, 1 + 0.3 * kDt * i, 0.2));
    scene.StandAt(-3);
  }
  const double end = 1 + 0.3 * kDt * 499;
  EXPECT_GE(scene.state(1).X_MO.translation().y(), end + kMiddleCharge.radius + 0.15 - 2e-3);
}

TEST(RigidBodiesAndRobot, ReleasedBodyHasTheVelocityItWasCarriedWith) {
  ModuleModel module = GroundOf(20);
  AddCharge(module, kMiddleCharge, At(0, 1, 1));
  Pusher scene(module);
  scene.StandAt(-3);
  scene.dut.Hold(0);
  const Vector3d v(0.1, 0.4, 0);
  const double turn = 0.5;
  for (int i = 1; i <= 100; ++i) {
    scene.StandAt(-3);
    scene.dut.MoveHeld(0, At(v.x() * kDt * i, 1 + v.y() * kDt * i, 1) *
                              AngleAxisd(turn * kDt * i, Vector3d::UnitZ()));
  }
  scene.dut.Release(0);
  EXPECT_FALSE(scene.state().is_held);
  EXPECT_LT((scene.state().v_M - v).norm(), 1e-9);
  EXPECT_LT((scene.state().w_M - turn * Vector3d::UnitZ()).norm(), 1e-6);
  const double z = scene.state().X_MO.translation().z();
  for (int i = 0; i < 50; ++i) scene.StandAt(-3);
  EXPECT_NEAR(scene.state().X_MO.translation().z(), z - 9.81 * 0.2 * 0.2 / 2, 5e-3);
  EXPECT_NEAR(scene.state().v_M.y(), v.y(), 1e-9);
}

/// All that can happen; the answer is every bit of every step.
std::vector<double> Mission(RigidBodies& dut, size_t bodies) {
  std::vector<double> all;
  for (int i = 0; i < 2500; ++i) {
    if (i == 500) dut.Push(1, {0.3, 0.5, 0.2}, {1, 1.5, 0.2});
    if (i == 1200) dut.Hold(0);
    if (i >= 1200 && i < 1500) dut.MoveHeld(0, At(0, 1.2, 0.2 + 0.001 * (i - 1200)));
    if (i == 1500) dut.Release(0);
    if (i == 2000) dut.Remove(1);
    const std::vector<Isometry3d> X = {At(0.1, -1 + 0.0012 * i, 0.22) *
                                       AngleAxisd(0.0003 * i, Vector3d::UnitZ())};
    dut.Step(kDt, X);
    for (size_t body = 0; body < bodies; ++body) {
      const BodyState& state = dut.states()[body];
      all.insert(all.end(), state.X_MO.data(), state.X_MO.data() + 16);
      all.insert(all.end(), state.v_M.data(), state.v_M.data() + 3);
      all.insert(all.end(), state.w_M.data(), state.w_M.data() + 3);
      all.push_back(state.touched_by);
      all.push_back(state.touches_ground);
    }
  }
  return all;
}

TEST(RigidBodiesAndRobot, SecondRunIsTheFirstToTheLastBitAlsoAfterAReset) {
  ModuleModel module = GroundOf(20);
  AddStandingCharge(module, kMiddleCharge, 0, 0.6);
  AddStandingCharge(module, kSmallCharge, 1, 1.5);
  AddMovable(module, Shape::Box({0.3, 0.2, 0.3}), 3, At(0, 1.2, 0.15));
  AddMovable(module, Shape::Capsule(0.05, 0.2), 1, At(0.3, 1, 0.15));
  const RobotModel robot = BoxRobot({1, 1, 0.4});
  RigidBodies one(module, robot), other(module, robot);
  const std::vector<double> first = Mission(one, 4);
  const auto same = [&first](const std::vector<double>& run) {
    return std::memcmp(first.data(), run.data(), first.size() * sizeof(double)) == 0;
  };
  EXPECT_NE(first[4 * 24 * 2000], first[0]) << "things have moved";
  EXPECT_TRUE(same(Mission(other, 4)));
  for (int again = 0; again < 2; ++again) {
    one.Reset();
    EXPECT_EQ(one.states()[0].X_MO.matrix(), module.movables[0].X_MO.matrix());
    EXPECT_FALSE(one.states()[1].is_gone);
    EXPECT_TRUE(same(Mission(one, 4))) << again;
  }
}

TEST(RigidBodiesAndRobot, Equation8HoldsWhereIsectorsMeetAToppledCharge) {
  ModuleModel module = GroundOf(20);
  AddStandingCharge(module, kMiddleCharge, 0, 0.3);
  BuiltWorld world(module);
  Pusher scene(module);
  scene.dut.Push(0, {0.5, 2, 0}, {0, 0.3, 0.2});
  const double a = module.movables[0].explosive->radius;
  const double h = module.movables[0].explosive->half_height;
  CastMemory memory;
  SegmentHit hit;
  int on_side = 0;
  for (int i = 0; i < 300; ++i) {
    scene.StandAt(-3);
    const Isometry3d& X_MO = scene.state().X_MO;
    ASSERT_TRUE(world.Move(world.ObjectOfMovable(0), X_MO));
    for (int line = 0; line < 12; ++line) {
      const double angle = line * std::numbers::pi / 6;
      const Vector3d direction(std::cos(angle), std::sin(angle), 0);
      const SegmentQuery query{.start = X_MO.translation() - direction,
                               .direction = direction,
                               .length = 2,
                               .class_mask = kModuleBomb | kBombObject};
      world.Cast({&query, 1}, {&hit, 1}, memory);
      ASSERT_TRUE(hit.hit);
      ASSERT_EQ(world.MovableOfObject(hit.object), 0);
      const Vector3d p = X_MO.inverse() * hit.point;  // the bomb's own frame, so x0 = y0 = z0 = 0
      const double radial = p.head<2>().squaredNorm() - a * a;
      EXPECT_LE(std::abs(p.z()), h + 1e-9);
      if (std::abs(p.z()) < h - 1e-9) {
        EXPECT_NEAR(radial, 0, 1e-9);
        ++on_side;
      } else {
        EXPECT_LE(radial, 1e-9);
      }
    }
  }
  EXPECT_GT(on_side, 300);
  EXPECT_GT(TiltOf(scene.state()), 1);
}

TEST(RigidBodiesAndRobot, HandsDoNotShoveWhatOnlyPressesThePads) {
  const RobotModel robot = LoadRobot(EOD_DATA_DIR "/sim/robots/eod_robot.sdf");
  RobotState state = HomeState(robot);
  state.right_opening = robot.joints[kGripperOpening].upper;
  std::vector<Isometry3d> X;
  LinkPoses(robot, state, X);
  const auto left = static_cast<size_t>(FindLink(robot, "left_hand"));
  const double pad = 0.005, inward = X[left].linear()(0, 0);
  ASSERT_NEAR(std::abs(inward), 1, 1e-9) << "+X of the left hand is level";
  for (const double depth : {0.8 * pad, 1.6 * pad}) {
    ModuleModel module;  // no ground: the box hangs where it is until something touches it
    const double half = 0.03;
    const Isometry3d X_MO = X[left] * At(half - depth, 0.08, 0);
    AddMovable(module, Shape::Box(Vector3d::Constant(2 * half)), 1, X_MO);
    RigidBodies dut(module, robot);
    dut.Step(kDt, X);
    const bool touched = (dut.states()[0].touched_by & BitOf(Part::kLeftHand)) != 0;
    EXPECT_EQ(touched, depth > pad) << depth;
  }
}

}  // namespace
}  // namespace eod::sim
