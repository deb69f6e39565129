#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "sim/score/scorer.h"
#include "sim/task/task.h"

namespace eod::sim {

inline const std::filesystem::path kData = EOD_DATA_DIR;

/// The rules that the product ships: tests derive their numbers from them.
inline const Rules& TheRules() {
  static const Rules rules = LoadRules(kData / "sim/rules/eod_rules.toml");
  return rules;
}
inline const ScoreRules& ThePoints() { return TheRules().score; }

/// A yard 100 m east of the world's origin with a wall, two charges, and a can at (0, 10) whose rim
/// is 0.85 m high.
inline ModuleModel Yard() {
  ModuleModel module;
  module.id = 3;
  module.name = "yard";
  module.p_WM = {100, 0, 0};
  for (const char* name : {"wall", "can"}) {
    WorldObject object;
    object.name = name;
    module.objects.push_back(object);
  }
  module.objects[1].X_MO.translation() = Eigen::Vector3d(0, 10, 0);
  module.vessels.push_back({.name = "can",
                            .X_MV = module.objects[1].X_MO,
                            .inner_radius = 0.25,
                            .net_z = 0.5,
                            .rim_z = 0.85});
  for (const char* name : {"charge", "cone"}) {
    MovableObject movable;
    movable.name = name;
    module.movables.push_back(movable);
  }
  return module;
}

inline TaskStep StepTo(TaskStep::Kind kind, const std::string& object = "", double weight = 1) {
  TaskStep step;
  step.kind = kind;
  step.object = object;
  step.text = "do it";
  step.weight = weight;
  return step;
}

/// Two steps that ask for no contact.
inline Scenario TwoSteps() {
  Scenario scenario;
  scenario.file = "x.toml";
  scenario.name = std::string("two_steps");
  scenario.module = 3;
  scenario.par_time_s = 100;
  scenario.steps = {StepTo(TaskStep::Kind::kReach), StepTo(TaskStep::Kind::kReach)};
  return scenario;
}

/// A mission under way, judged; its samples are made by hand.
struct Judged {
  static constexpr double kStep = 0.1;  // [s]
  Scorer dut;
  ScoreSample sample;
  int steps;

  explicit Judged(const Scenario& scenario = TwoSteps())
      : dut(scenario, Yard(), TheRules()), steps(static_cast<int>(scenario.steps.size())) {
    sample.module = 3;
    sample.position = Yard().p_WM;
    sample.mission_state = static_cast<int>(MissionState::kRun);
    Tell();
  }
  void Tell() {
    ++sample.step;
    dut.Advance(sample);
  }
  void Step() {
    sample.mission_s += kStep;
    Tell();
  }
  void Steps(int count) {
    for (int i = 0; i < count; ++i) Step();
  }
  /// So many seconds, to the next step.
  void Wait(double seconds) { Steps(static_cast<int>(seconds / kStep + 0.5)); }
  /// Along Y, at 1 m/s.
  void Drive(double metres) {
    const double sign = metres < 0 ? -1 : 1;
    sample.speed_mps = sign;
    for (int i = 0; i < sign * metres / kStep - 0.5; ++i) {
      sample.position.y() += sign * kStep;
      Step();
    }
    sample.speed_mps = 0;
    Step();
  }
  void CompleteStep() {
    ++sample.mission_step;
    Step();
  }
  void End(MissionState state, FailReason reason = FailReason::kNone) {
    sample.mission_state = static_cast<int>(state);
    sample.fail_reason = static_cast<int>(reason);
    Step();
  }
  void Succeed() {
    sample.mission_step = steps;
    End(MissionState::kSuccess);
  }
  double safety() const { return dut.points()[1]; }
  double precision() const { return dut.points()[2]; }
  double time() const { return dut.points()[3]; }
  double economy() const { return dut.points()[4]; }
};

inline constexpr Rubric kRubric{};  // of a scenario that says nothing else

/// The events of one kind.
inline std::vector<ScoreEvent> EventsOf(const Scorer& scorer, ScoreMark mark) {
  std::vector<ScoreEvent> events;
  for (const ScoreEvent& event : scorer.events()) {
    if (event.mark == mark) events.push_back(event);
  }
  return events;
}

}  // namespace eod::sim
