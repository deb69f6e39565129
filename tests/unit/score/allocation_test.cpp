#include <gtest/gtest.h>

#include "tests/unit/counting_new.h"
#include "tests/unit/score/judged.h"

namespace eod::sim {
namespace {

TEST(ScorerAllocation, NoStepAllocatesNotEvenThatWhichStartsAMission) {
  Scenario scenario = TwoSteps();
  scenario.precision.resize(1);
  scenario.precision[0].kind = PrecisionSpec::Kind::kContacts;
  scenario.precision[0].worst = 1;
  scenario.procedure.resize(2);
  Judged run(scenario);
  const std::array<double, 2> moved{};
  run.sample.moved_m = moved;
  run.sample.contact_object = "wall";
  const long before = AllocationCount();
  for (int i = 0; i < 5000; ++i) {
    run.sample.contact_parts = i % 7;
    run.sample.wanted_mask = run.sample.blocked_mask = i % 90 > 40 ? 1 : 0;
    run.sample.pitch_deg = i % 50;
    run.sample.position.y() += 0.1;
    run.sample.speed_mps = i % 3 - 1;
    run.sample.joint[2] = i % 40;
    run.Step();
  }
  run.sample.mission_s = 0;
  run.Tell();
  run.Succeed();
  EXPECT_EQ(AllocationCount() - before, 0);
  EXPECT_GT(before, 0);  // the counter is in place
}

}  // namespace
}  // namespace eod::sim
