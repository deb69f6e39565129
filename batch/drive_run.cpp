#include "batch/drive_run.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/scenario/variation.h"

namespace eod::batch {
namespace {

const sim::WorldModel& WorldOf(const Ground& ground, const sim::Scenario& scenario) {
  for (const sim::WorldModel& world : ground.worlds) {
    if (world.modules.front().id == scenario.module) return world;
  }
  throw std::runtime_error(
      fmt::format("{}: module {} is not in the world", scenario.file.string(), scenario.module));
}

bool HasEnded(const sim::TaskStatus& task) {
  return task.state == sim::MissionState::kSuccess || task.state == sim::MissionState::kFail ||
         task.state == sim::MissionState::kAbort;
}

Duration LimitOf(const sim::Scenario& scenario, const RunLimits& limits) {
  if (scenario.time_limit_s == 0) return limits.longest;
  const auto own = std::chrono::milliseconds(std::llround(scenario.time_limit_s * 1000));
  return std::min<Duration>(limits.longest, own + limits.preparing);
}

Outcome OutcomeOf(const sim::TaskStatus& task, const box::BoxNode& box) {
  switch (task.state) {
    case sim::MissionState::kSuccess:
      return {};
    case sim::MissionState::kFail:
      return {.kind = Outcome::Kind::kFailure, .reason = task.fail_reason};
    case sim::MissionState::kAbort:
      return {.kind = Outcome::Kind::kAbort};
    default:
      return {.kind = box.script_failure() ? Outcome::Kind::kScript : Outcome::Kind::kUnfinished};
  }
}

}  // namespace

RunInputs InputsOf(const Ground& ground, const PlannedRun& run) {
  RunInputs inputs = ground.inputs;
  inputs.scenario = run.pair->scenario_print;
  inputs.script = run.pair->script_print;
  return inputs;
}

std::optional<RunRecord> DriveRun(const Ground& ground, const PlannedRun& run,
                                  const RunLimits& limits, const std::atomic<bool>& stop) {
  const sim::Scenario scenario = sim::Vary(run.pair->scenario, run.repetition);
  lockstep::LockStepRig rig(ground.rig, ground.robot, WorldOf(ground, scenario), scenario);
  box::BoxNodeConfig config;
  config.dbc_file = ground.rig.bridge.dbc_file;
  config.map_file = ground.rig.bridge.map_file;
  config.script = run.pair->script;
  const box::BoxNode& box = rig.AddBox(config);
  const sim::TaskStatus& task = rig.simulator().last().task;

  rig.RunUntil(
      [&] {
        return HasEnded(task) || box.is_script_done() || stop.load(std::memory_order_relaxed);
      },
      LimitOf(scenario, limits));
  if (box.is_script_done() && !box.script_failure()) {
    rig.RunUntil([&] { return HasEnded(task); }, limits.closing);
  }
  if (stop) return std::nullopt;
  const Outcome outcome = OutcomeOf(task, box);
  return RunRecord{.scenario = scenario.name,
                   .script = run.pair->script_name,
                   .repetition = run.repetition,
                   .inputs = InputsOf(ground, run),
                   .expected = run.pair->expected,
                   .outcome = outcome,
                   .score = task.score,
                   .elapsed_s = task.elapsed_s,
                   .simulated_s = ToSeconds(rig.now() - ground.rig.start),
                   .collisions = task.collisions,
                   .steps_done = task.step,
                   .steps = task.steps,
                   .why = outcome.kind == Outcome::Kind::kScript ? *box.script_failure() : ""};
}

}  // namespace eod::batch
