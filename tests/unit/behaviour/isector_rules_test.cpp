#include <random>

#include <gtest/gtest.h>

#include "tests/unit/behaviour/operator.h"

namespace eod::sim {
namespace {

TEST(IsectorRules, AreAllInForceUnlessToldOtherwise) {
  const SimulatorConfig config;
  EXPECT_TRUE(config.rules.module_masks);
  EXPECT_TRUE(config.rules.dynamic_loading);
  EXPECT_TRUE(config.rules.distance_factor);
}

TEST(IsectorRules, DynamicLoadingSavesSegmentsAndChangesNothingElse) {
  Operator loaded;
  Operator all({.rules = {.dynamic_loading = false}});
  size_t every_segment = 0;
  for (const IsectorSpec& isector : TheRobot().isectors) every_segment += isector.segments.size();
  std::mt19937 random(11);
  for (int i = 0; i < 200; ++i) {
    for (Operator* op : {&loaded, &all}) op->Press({});
    const int motion = static_cast<int>(random() % kMotionCount);
    for (int step = 0; step < 50; ++step) {
      for (Operator* op : {&loaded, &all}) {
        op->Press({motion, kDriveForward});
        op->Step();
      }
      ASSERT_EQ(loaded.dut.last(), all.dut.last()) << i << "." << step;
      ASSERT_EQ(all.dut.isectors().segments().size(), every_segment);
      ASSERT_LT(loaded.dut.isectors().segments().size(), every_segment);
    }
  }
  EXPECT_NE(loaded.dut.last().contact_parts, 0u);  // it got as far as the wall
}

/// The flat module, and a copy of it that stands a metre nearer as another module.
WorldModel TwoModules() {
  WorldModel world = TheWorld();
  ModuleModel copy = world.Module(1);
  copy.id = 2;
  copy.class_bit = kModuleSlope;
  copy.p_WM.y() -= 1;
  for (CollisionTriangle& triangle : copy.triangles) {
    triangle.class_mask = (triangle.class_mask & ~kModuleFlat) | kModuleSlope;
  }
  world.modules.push_back(copy);
  return world;
}

TEST(IsectorRules, ModuleMasksKeepOtherModulesOut) {
  const WorldModel world = TwoModules();
  const auto range_ahead = [&](bool module_masks) {
    Simulator dut(TheRobot(), world, FirstDrive(),
                  WithRules({.rules = {.module_masks = module_masks}}));
    dut.Step(TimePoint{}, {});
    const int sight = FindIsector(TheRobot(), "LOS_FRONT");
    return dut.isectors().isector(sight).Hit(0, dut.last().step).range;
  };
  // From the chassis front to the wall; the copy's wall stands 1 m nearer.
  EXPECT_NEAR(range_ahead(true), 4.0 - 0.475, 1e-9);
  EXPECT_NEAR(range_ahead(false), 3.0 - 0.475, 1e-9);
}

/// How far the chassis' front gets into the wall, if the wall stands `shift` farther off. A robot
/// that is in it is let off: its guards, which start at the front, then look at the wall's back.
double Penetration(const RobotModel& robot, double shift, const SimulatorConfig& config) {
  WorldModel world = TheWorld();
  for (CollisionTriangle& triangle : world.modules[0].triangles) {
    for (Eigen::Vector3d& corner : triangle.corner) corner.y() += shift;
  }
  Simulator dut(robot, world, FirstDrive(), WithRules(config));
  OperatorCommand command;
  command.motion_permitted = true;
  command.motion_rate[kDriveForward] = 1;
  double penetration = -4.0;
  for (int i = 0; i < 200 && dut.last().contact_parts == 0 && penetration <= 0; ++i) {
    command.stamp += config.period;
    dut.Step(command.stamp, command);
    penetration = dut.last().state.position.y() + 0.475 - (4.0 + shift);
  }
  return penetration;
}

TEST(IsectorRules, FixedDistanceLetsAFastRobotPenetrate) {
  // 2.6 m/s at 50 Hz: 52 mm a step, beyond the skin of 50 mm of the guards at the chassis' front.
  constexpr double kSpeed = 2.6, kStep = kSpeed * 0.02, kSkin = 0.05;
  constexpr int kPlaces = 52;  // a millimetre apart, so that one of them is the worst to 1 mm
  RobotModel robot = WithIsectors(TheRobot(), {"TRIPOD", "GUARD_FRONT"});
  robot.drive_speed = {kSpeed, kSpeed, kSpeed};
  double worst_fixed = -1, worst_eq2 = -1;
  for (int i = 0; i < kPlaces; ++i) {
    const double shift = i * kStep / kPlaces;
    SimulatorConfig config{.period = std::chrono::milliseconds(20)};
    worst_eq2 = std::max(worst_eq2, Penetration(robot, shift, config));
    config.rules.distance_factor = false;
    worst_fixed = std::max(worst_fixed, Penetration(robot, shift, config));
  }
  // With Eq. 2 the gap is above D0; without, a step goes beyond it by up to its length less D0.
  EXPECT_LT(worst_eq2, -kSkin);
  EXPECT_LE(worst_fixed, kStep - kSkin + 1e-9);
  EXPECT_GT(worst_fixed, kStep - kSkin - kStep / kPlaces - 1e-9);
}

}  // namespace
}  // namespace eod::sim
