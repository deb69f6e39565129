#include "sim/stance/stance.h"

#include <numbers>

#include <gtest/gtest.h>

#include "sim/stance/tilt_guard.h"
#include "sim/world/analytic_world.h"
#include "sim/world/world_model.h"
#include "tests/unit/counting_new.h"
#include "tests/unit/sim/random_scene.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kStep = 0.004;
constexpr double kGravity = 9.80665;
constexpr uint32_t kGround = kModuleFlat | kClampProxy;

const RobotModel& TheRobot() {
  static const RobotModel robot = LoadRobot(EOD_DATA_DIR "/sim/robots/eod_robot.sdf");
  return robot;
}

/// Stands on a plane through the origin.
struct OnPlane {
  RobotModel robot = TheRobot();
  AnalyticWorld world;
  Stance dut{robot, kModuleFlat};
  RobotState state = HomeState(robot);
  std::vector<Eigen::Isometry3d> X_ML;

  explicit OnPlane(const Attitude& plane, double friction = 0) {
    if (friction > 0) robot.stance.friction = friction;
    world.AddPlane("ground", kGround, Vector3d::Zero(), ToRotation(plane).col(2));
    state.attitude = plane;
    state = dut.PutDown(world, state, X_ML);
  }
  void Step(const Vector3d& way = Vector3d::Zero()) {
    const RobotState before = state;
    state.position += way;
    LinkPoses(robot, state, X_ML);
    state = dut.Stand(world, X_ML, before, state, kStep);
  }
};

TEST(Stance, LiesOnThePlaneWhereverItLooks) {
  for (const double heading : {0.0, 40.0, 90.0, 200.0}) {
    OnPlane on({0, 20 * kDegree, 5 * kDegree});
    on.state.attitude.heading = heading * kDegree;
    for (int i = 0; i < 1000; ++i) on.Step();
    const Vector3d up = ToRotation(on.state.attitude).col(2);
    const Vector3d normal = ToRotation({0, 20 * kDegree, 5 * kDegree}).col(2);
    EXPECT_LT((up - normal).norm(), 1e-8) << heading;
    EXPECT_NEAR(on.state.position.z(), 0, 1e-8);
    EXPECT_TRUE(on.state.at_rest) << heading;
  }
}

TEST(Stance, RobotAtRestKeepsItsBits) {
  OnPlane on({0.7, 17 * kDegree, -9 * kDegree});
  ASSERT_TRUE(on.state.at_rest);
  const RobotState rests = on.state;
  for (int i = 0; i < 100; ++i) {
    on.Step();
    ASSERT_EQ(on.state, rests);
  }
}

TEST(Stance, FallsFreelyWhereNothingIsBelow) {
  AnalyticWorld nothing;
  OnPlane on({});
  RobotState state = on.state;
  std::vector<Eigen::Isometry3d> X_ML;
  Stance dut(TheRobot(), kModuleFlat);
  double fallen = 0;
  for (int i = 1; i <= 100; ++i) {
    LinkPoses(TheRobot(), state, X_ML);
    state = dut.Stand(nothing, X_ML, state, state, kStep);
    EXPECT_NEAR(state.fall_speed, kGravity * kStep * i, 1e-9);
    fallen += kGravity * kStep * i * kStep;
    EXPECT_NEAR(state.position.z(), -fallen, 1e-9);
    EXPECT_NEAR(state.attitude.pitch, 0, 1e-9);
    EXPECT_FALSE(state.at_rest);
  }
}

TEST(Stance, LandsFromAFallExactlyOnTheGround) {
  OnPlane on({});
  on.state.position.z() = 0.3;
  on.state.at_rest = false;
  int steps = 0;
  for (; steps < 200 && !on.state.at_rest; ++steps) {
    on.Step();
    ASSERT_GT(on.state.position.z(), -1e-9);
  }
  // 0.3 m = g t^2 / 2.
  EXPECT_NEAR(steps * kStep, std::sqrt(2 * 0.3 / kGravity), 0.02);
  EXPECT_NEAR(on.state.position.z(), 0, 1e-9);
  EXPECT_EQ(on.state.fall_speed, 0);
}

TEST(Stance, HoldsUpToTheAngleOfFrictionAndSlidesBeyond) {
  const double mu = std::tan(20 * kDegree);
  OnPlane holds({0, 19.9 * kDegree, 0}, mu);
  for (int i = 0; i < 250; ++i) holds.Step();
  EXPECT_EQ(holds.state.slip.norm(), 0);
  EXPECT_EQ(holds.state.position.y(), 0);
  OnPlane slides({0, 25 * kDegree, 0}, mu);
  for (int i = 0; i < 250; ++i) slides.Step();
  const double a = kGravity * (std::sin(25 * kDegree) - mu * std::cos(25 * kDegree));
  EXPECT_NEAR(slides.state.slip.norm(), a * 1.0, 1e-6);
  // Along the slope a t^2 / 2 (and half a step), downhill is backwards.
  EXPECT_NEAR(slides.state.position.y(), -a / 2 * (1 + kStep) * std::cos(25 * kDegree), 1e-4);
  EXPECT_NEAR(slides.state.position.z(), slides.state.position.y() * std::tan(25 * kDegree), 1e-6);
}

TEST(Stance, SlidesSidewaysDownASideSlope) {
  OnPlane on({0, 0, 25 * kDegree}, std::tan(20 * kDegree));
  for (int i = 0; i < 250; ++i) on.Step();
  EXPECT_GT(on.state.position.x(), 0.3);  // right side down
  EXPECT_NEAR(on.state.position.y(), 0, 1e-6);
}

TEST(Stance, SlideStopsWhereFrictionHolds) {
  OnPlane on({0, 10 * kDegree, 0}, std::tan(20 * kDegree));
  on.state.slip = {0, -1};
  on.state.at_rest = false;
  int steps = 0;
  for (; steps < 1000 && !on.state.at_rest; ++steps) on.Step();
  const double brake =
      kGravity * (std::tan(20 * kDegree) * std::cos(10 * kDegree) - std::sin(10 * kDegree));
  EXPECT_NEAR(steps * kStep, 1 / brake, 0.03);
  EXPECT_LT(on.state.position.y(), -0.2);
}

TEST(Stance, CastsOneLineForEachPointThatLooksDown) {
  OnPlane on({});
  on.Step();
  uint64_t down = 0;
  for (const SupportPoint& point : on.robot.stance.points) {
    // Flippers stand upright: their outer half looks down no more.
    const Vector3d n_M = on.X_ML[point.link].linear() * point.n_L;
    if (n_M.z() <= 0.1) ++down;
  }
  EXPECT_EQ(on.dut.counters().segments, down);
  EXPECT_LE(down, 90u);
  EXPECT_EQ(on.dut.pivots(), 0);  // stands on what it stood on
}

TEST(Stance, WorkStaysSmallWhileItDrivesOverRoughGround) {
  ModuleModel module;
  SeededNumbers numbers(9);
  AddObject(module, "ground", kGround, PlaneMesh(20, 20, 1));
  for (int i = 0; i < 400; ++i) {
    const Vector3d size(0.1, 0.1, numbers.Between(0.02, 0.15));
    AddObject(module, "post", kGround, BoxMesh(size),
              {numbers.Between(-1, 1), numbers.Between(0.7, 5), size.z() / 2});
  }
  const std::unique_ptr<World> world = BuildWorld(module);
  Stance dut(TheRobot(), kModuleFlat);
  std::vector<Eigen::Isometry3d> X_ML;
  RobotState state = dut.PutDown(*world, HomeState(TheRobot()), X_ML);
  LinkPoses(TheRobot(), state, X_ML);
  state = dut.Stand(*world, X_ML, state, state, kStep);
  const long before = AllocationCount();
  int pivots = 0, most = 0;
  constexpr int kSteps = 4000;
  for (int i = 0; i < kSteps; ++i) {
    const RobotState last = state;
    state.position += ToRotation(state.attitude).col(1) * 0.0012;
    LinkPoses(TheRobot(), state, X_ML);
    state = dut.Stand(*world, X_ML, last, state, kStep);
    pivots += dut.pivots();
    most = std::max(most, dut.pivots());
    ASSERT_LT(std::abs(state.attitude.pitch), 45 * kDegree);
  }
  EXPECT_EQ(AllocationCount() - before, 0);
  EXPECT_GT(before, 0);       // the counter is in place
  EXPECT_LT(pivots, kSteps);  // less than one a step
  EXPECT_LT(most, 20);
}

TEST(TiltGuard, RefusesTheMotionThatTiltsFurtherUntilTheRobotIsBack) {
  StanceSpec limits;
  limits.pitch_limit = 0.5;
  limits.roll_limit = 0.4;
  TiltGuard dut;
  const MotionSet forward = SetOf(kDriveForward), reverse = SetOf(kDriveReverse);
  dut.Update(limits, {0, 0.48, 0}, {0, 0.49, 0}, forward);
  EXPECT_EQ(dut.refused(), 0u);  // within
  dut.Update(limits, {0, 0.49, 0}, {0, 0.51, 0}, forward);
  EXPECT_EQ(dut.refused(), forward);
  dut.Update(limits, {0, 0.51, 0}, {0, 0.51, 0}, 0);
  EXPECT_EQ(dut.refused(), forward);  // stands
  dut.Update(limits, {0, 0.51, 0}, {0, 0.505, 0}, reverse);
  EXPECT_EQ(dut.refused(), 0u);  // the way back is free, and then the way on
  dut.Update(limits, {0, 0, -0.39}, {0, 0, -0.41}, SetOf(kTurnLeft));
  EXPECT_EQ(dut.refused(), SetOf(kTurnLeft));
  dut.Update(limits, {0, 0, -0.41}, {0, 0, -0.2}, 0);
  EXPECT_EQ(dut.refused(), 0u);
}

}  // namespace
}  // namespace eod::sim
