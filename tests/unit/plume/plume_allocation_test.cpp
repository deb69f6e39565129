#include <gtest/gtest.h>

#include "sim/plume/explosion.h"
#include "tests/unit/counting_new.h"
#include "tests/unit/plume/smoking_fire.h"

namespace eod::sim {
namespace {

TEST(Explosion, AllocatesNothingFromIgnitionToReset) {
  Explosion dut(TheExplosion());
  const long before = AllocationCount();
  for (const uint32_t seed : {1U, 2U}) {
    dut.Ignite({1, 2, 0}, seed, true);
    for (int step = 0; step < 2500; ++step) dut.Step(kStep);
    dut.Reset();
  }
  EXPECT_EQ(AllocationCount() - before, 0);
  EXPECT_GT(before, 0);  // the counter is in place
}

}  // namespace
}  // namespace eod::sim
