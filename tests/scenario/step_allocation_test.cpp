#include <gtest/gtest.h>

#include "tests/scenario/recorded_commands.h"
#include "tests/unit/counting_bullet.h"
#include "tests/unit/counting_new.h"

namespace eod::lockstep {
namespace {

/// A mission whose commands were recorded, in a simulator of its own. Where a menu command enters
/// the module, its bodies are made anew; no other step takes memory, and be it the first mission.
void ExpectNoStepAllocates(const std::vector<CommandedStep>& steps, sim::Simulator& dut) {
  int menu_command = sim::kMenuNone;
  for (const CommandedStep& step : steps) {
    const bool enters_module = step.command.menu_command != menu_command;
    menu_command = step.command.menu_command;
    const long before = AllocationCount(), before_in_bullet = bullet_allocations;
    dut.Step(step.now, step.command);
    if (enters_module) continue;
    ASSERT_EQ(AllocationCount() - before, 0) << "step " << dut.last().step;
    ASSERT_EQ(bullet_allocations - before_in_bullet, 0) << "step " << dut.last().step;
  }
}

sim::StepResult Play(const std::string& script, const std::string& scenario_name) {
  const sim::Scenario scenario = ShippedScenario(scenario_name);
  const auto steps = RecordCommands(
      box::LoadScript(kData / "firmware_emu/scripts" / (script + ".boxscript")), scenario);
  sim::Simulator dut(ShippedData().robot, ShippedData().world, scenario,
                     Mission::ShippedRig().sim.simulator);
  ExpectNoStepAllocates(steps, dut);
  return dut.last();
}

TEST(StepAllocation, NoStepTakesMemoryWhileAChargeIsGraspedCarriedAndDroppedIntoTheCan) {
  ASSERT_TRUE(kCountsBullet);
  const sim::StepResult last = Play("bomb_ground", "bomb_ground_m");
  EXPECT_EQ(last.disposal.bomb, sim::BombState::kInCan);
  EXPECT_EQ(last.task.state, sim::MissionState::kSuccess);
  EXPECT_GT(bullet_allocations, 0);
}

TEST(StepAllocation, NoStepTakesMemoryWhileADroppedChargeGoesOff) {
  const sim::StepResult last = Play("bomb_dropped", "bomb_ground_m");
  EXPECT_EQ(last.disposal.detonation, sim::DetonationCause::kDropped);
  EXPECT_EQ(last.task.fail_reason, sim::FailReason::kExploded);
}

}  // namespace
}  // namespace eod::lockstep
