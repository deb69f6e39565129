#include "batch/plan.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/batch/scratch_folder.h"

namespace eod::batch {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Planning : public testing::Test {
 protected:
  Planning() {
    for (const char* name : {"ramp", "stair", "bomb"}) {
      folder_.Put(std::string("scenarios/") + name + ".toml",
                  std::string("name = \"") + name + "\"\nmodule = 1\n");
    }
    folder_.Put("scripts/ramp.boxscript", "wait 1s\n");
    folder_.Put("scripts/bomb.boxscript", "wait 1s\n");
    folder_.Put("scripts/bomb.dropped.boxscript", "# expect: failure exploded\nwait 2s\n");
    folder_.Put("scripts/tour.boxscript", "wait 1s\n");
    folder_.Put("scripts/notes.txt", "");
  }
  Plan Make(const std::vector<std::string>& only = {}) const {
    return MakePlan(folder_ / "scenarios", folder_ / "scripts", only);
  }
  static std::vector<std::string> Names(const std::vector<PlannedRun>& runs) {
    std::vector<std::string> names;
    for (const PlannedRun& run : runs) names.push_back(run.name());
    return names;
  }
  ScratchFolder folder_;
};

TEST_F(Planning, PairsScriptsWithScenariosByName) {
  const Plan plan = Make();
  ASSERT_EQ(plan.pairs.size(), 3u);
  EXPECT_EQ(plan.pairs[0].script_name, "bomb");
  EXPECT_EQ(plan.pairs[1].script_name, "bomb.dropped");
  EXPECT_EQ(plan.pairs[1].scenario.name, "bomb");
  EXPECT_EQ(TextOf(plan.pairs[1].expected), "failure exploded");
  EXPECT_EQ(plan.pairs[2].script_name, "ramp");
  EXPECT_EQ(plan.pairs[2].script.file, "ramp.boxscript") << "the same wherever the folder is";
  EXPECT_THAT(plan.notices, ElementsAre("tour.boxscript: no scenario is named 'tour': left out",
                                        "stair: has no script: left out"));
}

TEST_F(Planning, RunsAreInTheOrderOfTheResults) {
  const Plan plan = Make();
  EXPECT_THAT(Names(RunsOf(plan, 2)), ElementsAre("bomb.0000", "bomb.0001", "bomb.dropped.0000",
                                                  "bomb.dropped.0001", "ramp.0000", "ramp.0001"));
}

TEST_F(Planning, ShardsTakeEveryRunOnce) {
  const Plan plan = Make();
  std::vector<std::string> all;
  for (int shard = 0; shard < 4; ++shard) {
    const auto names = Names(RunsOf(plan, 5, {.index = shard, .count = 4}));
    EXPECT_NEAR(static_cast<double>(names.size()), 15 / 4.0, 1);
    all.insert(all.end(), names.begin(), names.end());
  }
  EXPECT_THAT(all, testing::UnorderedElementsAreArray(Names(RunsOf(plan, 5))));
}

TEST_F(Planning, OnlyLeavesTheOthersOutWithoutAWord) {
  const Plan plan = Make({"bomb"});
  EXPECT_EQ(plan.pairs.size(), 2u);
  EXPECT_THAT(plan.notices, ElementsAre("tour.boxscript: no scenario is named 'tour': left out"));
  EXPECT_THROW(Make({"bom"}), std::runtime_error);
}

TEST_F(Planning, NothingToRunIsAnError) {
  try {
    Make({"stair"});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("no script NAME.boxscript of a scenario NAME"));
  }
}

TEST_F(Planning, AScriptThatDoesNotReadStopsTheBatchBeforeItBegins) {
  folder_.Put("scripts/ramp.boxscript", "levitate\n");
  try {
    Make();
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("ramp.boxscript:1: 'levitate'"));
  }
}

TEST(ShardText, IsAnIndexFromZeroOfACount) {
  EXPECT_EQ(ParseShard("2/3").index, 2);
  EXPECT_EQ(ParseShard("2/3").count, 3);
  for (const char* text : {"3/3", "-1/3", "1", "1/0", "1/3x", "", "a/b"}) {
    EXPECT_THROW(ParseShard(text), std::runtime_error) << text;
  }
}

}  // namespace
}  // namespace eod::batch
