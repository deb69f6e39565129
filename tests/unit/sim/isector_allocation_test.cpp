#include <gtest/gtest.h>

#include "sim/isectors/isector_batch.h"
#include "sim/isectors/isector_methods.h"
#include "sim/isectors/isector_set.h"
#include "sim/isectors/terrain_reading.h"
#include "sim/isectors/tripod_reading.h"
#include "sim/world/analytic_world.h"
#include "tests/unit/counting_new.h"
#include "tests/unit/sim/random_scene.h"

namespace eod::sim {
namespace {

using Eigen::Vector3d;

TEST(IsectorBatch, AllocatesInItsFirstCastAlone) {
  AnalyticWorld world;
  world.AddPlane("ground", kModuleFlat | kClampProxy | kBumpProxy, {0, 0, 0}, Vector3d::UnitZ());
  std::vector<Isector> isectors = {
      MakeBump("bump", {1, 1, 1, 1, 1, 1}), MakeHat("hat"), MakeLos("los", 5),
      MakeTripod("tripod", {Vector3d(-1, 1, 0), {1, 1, 0}, {0, -1, 0}})};
  IsectorBatch dut;
  const long before = AllocationCount();
  dut.CastIsectors(isectors, world, 0);
  const long first = AllocationCount();
  EXPECT_GT(first, before);  // the counter is in place
  int legs = 0;
  for (int64_t step = 1; step < 100; ++step) {
    isectors[0].set_enabled(step % 2 == 0);
    isectors[0].EnableSegment(kPlusZ, step % 4 == 0);
    dut.CastIsectors(isectors, world, step);
    legs += ReadTripod(isectors[3], step).legs + (ReadHat(isectors[1], step) ? 1 : 0);
  }
  EXPECT_EQ(AllocationCount(), first);
  EXPECT_EQ(legs, 99 * 4);
}

TEST(IsectorSet, AllocatesNothingAfterItsLargestCast) {
  const RobotModel robot = LoadRobot(EOD_DATA_DIR "/sim/robots/eod_robot.sdf");
  AnalyticWorld world;
  world.AddPlane("ground", kModuleFlat | kClampProxy | kBumpProxy, {0, 0, 0}, Vector3d::UnitZ());
  std::vector<Eigen::Isometry3d> X_ML;
  LinkPoses(robot, HomeState(robot), X_ML);
  IsectorSet dut(robot, kModuleFlat);
  dut.Cast(world, X_ML, kAllMotions);
  const long before = AllocationCount();
  for (int motion = 0; motion < kMotionCount; ++motion) dut.Cast(world, X_ML, SetOf(motion));
  EXPECT_EQ(AllocationCount(), before);
}

TEST(IsectorSet, AllocatesNothingWhereItsSurroundingsAreGatheredOnTheWay) {
  const RobotModel robot = LoadRobot(EOD_DATA_DIR "/sim/robots/eod_robot.sdf");
  ModuleModel module;
  AddObject(module, "ground", kModuleFlat | kClampProxy | kBumpProxy, PlaneMesh(20, 20, 0.25));
  const std::unique_ptr<World> world = BuildWorld(module);
  std::vector<Eigen::Isometry3d> X_ML;
  LinkPoses(robot, HomeState(robot), X_ML);
  IsectorSet dut(robot, kModuleFlat);
  dut.Cast(*world, X_ML, kAllMotions);
  const long before = AllocationCount();
  uint64_t refills = 0;
  for (int step = 0; step < 300; ++step) {
    for (Eigen::Isometry3d& pose : X_ML) pose.translation().y() += 0.02;
    dut.Cast(*world, X_ML, kAllMotions);
    refills += dut.counters().refills;
  }
  EXPECT_EQ(AllocationCount(), before);
  EXPECT_GT(refills, 5u);  // 6 m, half a metre of margin
}

}  // namespace
}  // namespace eod::sim
