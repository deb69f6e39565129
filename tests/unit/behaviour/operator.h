#pragma once

#include <cmath>
#include <initializer_list>

#include "sim/simulator.h"
#include "tests/unit/behaviour/fixture.h"

namespace eod::sim {

inline const WorldModel& TheWorld() {
  static const WorldModel world = LoadWorld(kData / "sim/worlds/training_ground.sdf");
  return world;
}

inline const Scenario& FirstDrive() {
  static const Scenario scenario = LoadScenario(kData / "sim/scenarios/flat_first_drive.toml");
  return scenario;
}

/// With the rules that the product ships.
inline SimulatorConfig WithRules(SimulatorConfig config = {}) {
  static const Rules rules = LoadRules(kData / "sim/rules/eod_rules.toml");
  config.exercise = rules;
  return config;
}

/// Somebody at the controls of the shipped robot on the flat module, with a fresh command every
/// step.
struct Operator {
  Simulator dut;
  OperatorCommand command;
  TimePoint now{};
  Duration period;

  explicit Operator(const SimulatorConfig& config = {}) : Operator(TheSharpRobot(), config) {}
  Operator(const RobotModel& robot, const SimulatorConfig& config)
      : dut(robot, TheWorld(), FirstDrive(), WithRules(config)), period(config.period) {
    command.motion_permitted = true;
  }

  const StepResult& Step() {
    now += period;
    command.stamp = now;
    ++command.sequence;
    return dut.Step(now, command);
  }

  void Press(std::initializer_list<int> motions, double rate = 1) {
    command.motion_rate = {};
    for (const int motion : motions) command.motion_rate[motion] = rate;
  }

  /// Holds `motions` for so many steps, then lets go for one.
  const StepResult& Hold(std::initializer_list<int> motions, int steps, double rate = 1) {
    Press(motions, rate);
    for (int i = 0; i < steps; ++i) Step();
    Press({});
    return Step();
  }

  /// Both flippers from upright to level: 90 deg at 20 deg/s.
  void LevelFlippers() {
    const int steps = static_cast<int>(std::lround(4.5 / ToSeconds(period)));
    Hold({kFrontFlipperDown, kRearFlipperDown}, steps);
  }

  /// Drives forward until something stops it; returns the step in which it did.
  const StepResult& DriveIntoContact(int at_most = 10000) {
    Press({kDriveForward});
    for (int i = 0; i < at_most; ++i) {
      if (Step().contact_parts != 0) break;
    }
    return dut.last();
  }

  const RobotState& state() const { return dut.last().state; }
};

}  // namespace eod::sim
