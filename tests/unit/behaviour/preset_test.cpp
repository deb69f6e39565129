#include <gtest/gtest.h>

#include "sim/motion/drives.h"
#include "sim/motion/preset_run.h"
#include "tests/unit/behaviour/operator.h"

namespace eod::sim {
namespace {

const PresetSpec& Preset(const std::string& name) {
  for (const PresetSpec& preset : TheRobot().presets) {
    if (preset.name == name) return preset;
  }
  throw std::runtime_error("no preset " + name);
}

/// Asks for a preset until it moves no more, but no longer than `seconds`.
void RunTo(Operator& at, int preset, double seconds) {
  at.command.preset = preset;
  for (int i = 0; i < seconds / ToSeconds(at.period); ++i) {
    const RobotState before = at.state();
    at.Step();
    if (i > 0 && at.state() == before) break;
  }
}

TEST(Preset, TheSevenOfTheBoxAreInTheRobotFile) {
  const std::vector<std::string> names = {"stow",     "travel",   "ground_pick", "carry",
                                          "can_drop", "stair_up", "stair_down"};
  ASSERT_EQ(TheRobot().presets.size(), names.size());
  for (size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(TheRobot().presets[i].name, names[i]);
    EXPECT_EQ(TheRobot().presets[i].index, static_cast<int>(i) + 1);
  }
}

TEST(Preset, EachIsReachedExactlyFromTheOneBefore) {
  Operator at(TheRobot(), {});
  for (const PresetSpec& preset : TheRobot().presets) {
    RunTo(at, preset.index, 60);
    for (int j = 0; j < kJointCount; ++j) {
      if (!preset.joint[j]) continue;
      EXPECT_NEAR(at.state().joint[j], *preset.joint[j], 1e-8) << preset.name << " J" << j + 1;
    }
    EXPECT_EQ(at.dut.last().contact_parts, 0u) << preset.name;
  }
}

TEST(Preset, JointsNeverMoveFasterThanTheirRatesAllow) {
  Operator at(TheRobot(), {});
  at.command.preset = Preset("ground_pick").index;
  RobotState before = at.state();
  for (int i = 0; i < 5000; ++i) {
    at.Step();
    for (int j = 0; j < kJointCount; ++j) {
      EXPECT_LE(std::abs(at.state().joint[j] - before.joint[j]),
                TheRobot().joints[j].rate * ToSeconds(at.period) + 1e-12);
    }
    before = at.state();
  }
}

TEST(Preset, LettingGoOfTheRequestStopsOnTheWay) {
  Operator at(TheRobot(), {});
  at.command.preset = Preset("ground_pick").index;
  for (int i = 0; i < 500; ++i) at.Step();
  at.command.preset = 0;
  for (int i = 0; i < 100; ++i) at.Step();
  const RobotState stopped = at.state();
  at.Step();
  EXPECT_EQ(at.state(), stopped);
  EXPECT_GT(std::abs(stopped.joint[kBigArm] - *Preset("ground_pick").joint[kBigArm]), 0.1);
}

TEST(Preset, ContactEndsTheRunUntilItIsAskedForAnew) {
  // Flippers level before the wall: rising to travel, the small wheels would enter it.
  Operator at(TheRobot(), {});
  at.LevelFlippers();
  at.DriveIntoContact();
  at.Press({});
  RunTo(at, Preset("ground_pick").index, 60);
  ASSERT_NE(at.dut.last().contact_parts, 0u);
  const double short_of =
      std::abs(at.state().joint[kBigArm] - *Preset("ground_pick").joint[kBigArm]);
  EXPECT_GT(short_of, 1 * kDegree);
  EXPECT_EQ(at.dut.last().inhibit_reason, kReasonCollision);
  const RobotState stopped = at.state();
  for (int i = 0; i < 250; ++i) at.Step();
  EXPECT_EQ(at.state(), stopped);
}

TEST(Preset, WithAnArmButtonNeitherMovesAndTheReasonIsConflict) {
  Operator at(TheRobot(), {});
  at.command.preset = Preset("carry").index;
  at.Press({kWristUp});
  const RobotState before = at.state();
  for (int i = 0; i < 10; ++i) at.Step();
  EXPECT_EQ(at.state(), before);
  EXPECT_EQ(at.dut.last().inhibit_reason, kReasonConflict);
  EXPECT_TRUE(Contains(at.dut.last().inhibited, kWristUp));
}

TEST(Preset, WithoutPermissionNothingMoves) {
  Operator at(TheRobot(), {});
  at.command.motion_permitted = false;
  at.command.preset = Preset("carry").index;
  const RobotState before = at.state();
  for (int i = 0; i < 10; ++i) at.Step();
  EXPECT_EQ(at.state(), before);
}

}  // namespace
}  // namespace eod::sim
