#include <gtest/gtest.h>

#include "tests/unit/counting_bullet.h"
#include "tests/unit/counting_new.h"
#include "tests/unit/sim/bodies_scene.h"

namespace eod::sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

TEST(RigidBodiesAllocation, NoStepTakesMemory) {
  ASSERT_TRUE(kCountsBullet);
  ModuleModel module = GroundOf(40, 1);
  AddStandingCharge(module, kMiddleCharge, 0, 0.6);
  AddStandingCharge(module, kSmallCharge, 1, 1.5);
  AddStandingCharge(module, kLargeCharge, -0.3, 1.5);
  for (int i = 0; i < 6; ++i) {
    AddMovable(module, Shape::Box({0.3, 0.3, 0.3}), 3, At(-1 + 0.4 * i, 2, 0.15));
  }
  const RobotModel robot = BoxRobot({1, 1, 0.4});
  std::vector<Isometry3d> X = {At(0, -2, 0.25)};
  RigidBodies dut(module, robot);
  EXPECT_GT(bullet_allocations, 0);
  for (int run = 0; run < 3; ++run) {
    const long before = AllocationCount(), before_in_bullet = bullet_allocations;
    for (int i = 0; i < 3000; ++i) {
      X[0].translation().y() = -1 + 0.001 * i;
      if (i == 100) dut.Push(1, {0, 0.5, 0}, {1, 1.5, 0.15});
      if (i == 1000) dut.Hold(2);
      if (i > 1000 && i < 1500) dut.MoveHeld(2, At(-0.3, 1.5, 0.2 + 0.001 * (i - 1000)));
      if (i == 1500) dut.Release(2);
      if (i == 2000) dut.Remove(3);
      dut.Step(kDt, X);
    }
    EXPECT_EQ(AllocationCount() - before, 0) << "run " << run;
    EXPECT_EQ(bullet_allocations - before_in_bullet, 0) << "run " << run;
    dut.Reset();
  }
}

}  // namespace
}  // namespace eod::sim
