#include <gtest/gtest.h>

#include "tests/unit/counting_new.h"
#include "tests/unit/disposal/bench.h"

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

}  // namespace
}  // namespace eod::sim
