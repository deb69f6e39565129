#include "programs/sim_options.h"

#include <CLI/CLI.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eod::sim {
namespace {

using testing::HasSubstr;

SimOptions Parse(const std::string& command_line) {
  SimOptions options;
  CLI::App app;
  AddSimOptions(app, options);
  app.parse(command_line);
  return options;
}

TEST(SimOptions, AllIsectorRulesAreInForceAndDescribed) {
  const SimOptions options = Parse("");
  EXPECT_TRUE(options.node.simulator.rules.module_masks);
  EXPECT_TRUE(options.node.simulator.rules.dynamic_loading);
  EXPECT_TRUE(options.node.simulator.rules.distance_factor);
  EXPECT_THAT(Describe(options),
              HasSubstr("extended; module masks on, dynamic loading on, distance by Eq. 2\n"));
}

TEST(SimOptions, EachIsectorRuleCanBeLeftOut) {
  const SimOptions unmasked = Parse("--no-module-masks");
  EXPECT_FALSE(unmasked.node.simulator.rules.module_masks);
  EXPECT_THAT(Describe(unmasked), HasSubstr("module masks off, dynamic loading on, distance by"));
  const SimOptions loaded = Parse("--no-dynamic-loading --coverage paper");
  EXPECT_FALSE(loaded.node.simulator.rules.dynamic_loading);
  EXPECT_THAT(Describe(loaded), HasSubstr("paper; module masks on, dynamic loading off, distance"));
  const SimOptions fixed = Parse("--fixed-distance");
  EXPECT_FALSE(fixed.node.simulator.rules.distance_factor);
  EXPECT_THAT(Describe(fixed), HasSubstr("dynamic loading on, fixed distance D0\n"));
}

TEST(SimOptions, ScenarioIsAFileOrANameAndMayBeVaried) {
  const SimOptions options = Parse("--scenario slope_first --scenarios my --repetition 7");
  EXPECT_EQ(options.scenario, "slope_first");
  EXPECT_THAT(Describe(options), HasSubstr("slope_first, repetition 7; others from my\n"));
  EXPECT_FALSE(options.list);
  EXPECT_TRUE(Parse("--list").list);
}

TEST(SimOptions, GraspIsGuardedUnlessThePapersIsAskedFor) {
  EXPECT_EQ(Parse("").node.simulator.grasp, GraspMode::kGuarded);
  EXPECT_THAT(Describe(Parse("")), HasSubstr("grasp            guarded\n"));
  EXPECT_EQ(Parse("--grasp paper").node.simulator.grasp, GraspMode::kPaper);
  EXPECT_THAT(Describe(Parse("--grasp paper")), HasSubstr("grasp            paper\n"));
}

}  // namespace
}  // namespace eod::sim
