#include "tests/scenario/recorded_commands.h"

#include <stdexcept>

namespace eod::lockstep {

std::vector<CommandedStep> RecordCommands(const box::Script& script,
                                          const sim::Scenario& scenario) {
  std::vector<CommandedStep> steps;
  Mission mission(script, scenario);
  LockStepRig& rig = mission.rig();
  rig.SetStepSink([&](const sim::StepResult& step, const sim::AlarmTable&) {
    steps.push_back({step.time, rig.command()});
  });
  const bool ended = mission.Run(std::chrono::seconds(300));
  if (!ended) throw std::runtime_error(scenario.name + ": the script did not end");
  if (mission.box().script_failure()) {
    throw std::runtime_error(scenario.name + ": " + *mission.box().script_failure());
  }
  return steps;
}

}  // namespace eod::lockstep
