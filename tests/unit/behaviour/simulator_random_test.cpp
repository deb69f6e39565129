#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "tests/unit/behaviour/operator.h"

namespace eod::sim {
namespace {

using std::chrono::milliseconds;

constexpr double kWallY = 4.0;

/// Any command that a broken bridge could think of.
OperatorCommand RandomCommand(std::mt19937& random, const OperatorCommand& last) {
  const auto one_in = [&](int n) { return random() % static_cast<unsigned>(n) == 0; };
  OperatorCommand command = last;
  if (!one_in(50)) return command;
  ++command.sequence;
  command.motion_permitted = !one_in(10);
  for (double& rate : command.motion_rate) {
    rate = one_in(4) ? static_cast<double>(random() % 1000) / 999 : 0;
    if (one_in(200)) rate = std::numeric_limits<double>::quiet_NaN();
    if (one_in(200)) rate = std::numeric_limits<double>::infinity();
  }
  command.speed_range = static_cast<int>(random() % 5) - 1;
  command.menu_module = static_cast<int>(random() % 8);
  command.menu_command = one_in(5) ? static_cast<int>(random() % 8) : kMenuNone;
  command.inhibited = static_cast<MotionSet>(random());
  return command;
}

TEST(Simulator, TwoRunsOfTheSameRandomCommandsAreTheSameBits) {
  std::mt19937 random(2006);
  Operator a;
  Operator b;
  OperatorCommand command;
  TimePoint now{};
  for (int i = 0; i < 10000; ++i) {
    now += milliseconds(4);
    command = RandomCommand(random, command);
    if (i % 100 != 0) command.stamp = now;
    ASSERT_EQ(a.dut.Step(now, command), b.dut.Step(now, command)) << i;
    ASSERT_TRUE(a.state().position.allFinite()) << i;
  }
  EXPECT_GT(a.state().position.norm() + a.dut.last().task.collisions, 0);
}

TEST(Simulator, LimitsAndWallsHoldUnderRandomCommandsAtEveryPeriod) {
  for (const int period_ms : {1, 4, 20}) {
    std::mt19937 random(7);
    Operator op({.period = milliseconds(period_ms)});
    op.LevelFlippers();
    TimePoint now = op.now;
    OperatorCommand command;
    for (int i = 0; i < 4000; ++i) {
      now += milliseconds(period_ms);
      command = RandomCommand(random, command);
      command.menu_command = kMenuNone;
      command.motion_rate[kDriveForward] = i % 500 < 400 ? 1 : 0;  // again and again into the wall
      command.motion_rate[kDriveReverse] = 0;
      command.stamp = now;
      const RobotState& state = op.dut.Step(now, command).state;
      for (int j = 0; j < kJointCount; ++j) {
        ASSERT_GE(state.joint[j], TheRobot().joints[j].lower - 1e-12);
        ASSERT_LE(state.joint[j], TheRobot().joints[j].upper + 1e-12);
      }
      const bool before_wall = std::abs(state.position.x()) < 1.5;
      if (before_wall) {
        ASSERT_LT(state.position.y() + 0.475, kWallY) << period_ms << " ms, " << i;
      }
    }
  }
}

}  // namespace
}  // namespace eod::sim
