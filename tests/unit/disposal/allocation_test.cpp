#include <gtest/gtest.h>

#include "tests/unit/counting_new.h"
#include "tests/unit/disposal/bench.h"
#include "tests/unit/sim/random_scene.h"

namespace eod::sim {
namespace {

TEST(Disposal, AllocatesNothingFromTheFirstGraspToTheLastShot) {
  Bench bench(BombModule({CylinderM(), CylinderM()}));
  bench.bodies[1].X_MO.translation() = Eigen::Vector3d(3, 8, 0.12);
  bench.Open(0.08);
  bench.PlaceInHand(0, 0.01);
  // The test's own lists grow: poses, casts, contacts.
  bench.Look({});
  bench.isectors.Cast(bench.world, bench.X_ML, kAllMotions);
  bench.response.held.reserve(200);
  bench.response.contacts.reserve(200);
  std::vector<MotionDemand> demands;
  demands.reserve(16);
  for (const int motion : {kGripperClose, kBigArmUp, kDriveForward, kTurnLeft, kGripperOpen}) {
    demands.push_back(DemandFor({motion}));
  }
  const long before = AllocationCount();
  EXPECT_GT(before, 0);  // the counter is in place
  bench.panel = {.arm_key = 1, .fire_left = 1, .fire_right = 1, .circuit = 1};
  for (const MotionDemand& demand : demands) bench.Step(demand, 250);
  const int released = bench.released;
  bench.panel.arm_key = 2;
  bench.Step(MotionDemand{}, 251);
  bench.panel.nonce_echo = bench.dut.status().fire_nonce;
  bench.panel.fire_left = bench.panel.fire_right = 2;
  bench.Step(MotionDemand{}, 80);
  bench.dut.Reset();
  const long after = AllocationCount();
  EXPECT_EQ(after - before, 0);
  EXPECT_EQ(released, 0);
  EXPECT_EQ(bench.dut.status().held_body, -1);
}

TEST(Shot, AllocatesNothingInAWorldOfTriangles) {
  ModuleModel module = BombModule({CylinderM()});
  AddObject(module, "ground", kModuleBomb | kClampProxy | kBumpProxy, PlaneMesh(60, 60, 0.5));
  const std::unique_ptr<World> world = BuildWorld(module);
  const std::vector<BodyState> bodies(1);
  const std::vector<int> movables = {-1};
  CastMemory memory;
  memory.surroundings.Reserve();
  Eigen::Isometry3d X_MB(Eigen::Translation3d(0, 0, 1));
  X_MB.rotate(Eigen::AngleAxisd(-0.1, Eigen::Vector3d::UnitX()));
  const long before = AllocationCount();
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(ShotFrom(X_MB, *world, module, bodies, movables, TheRules().disrupter, memory));
  }
  EXPECT_EQ(AllocationCount(), before);
}

}  // namespace
}  // namespace eod::sim
