#include "batch/batch_run.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/batch/batch_setup.h"

namespace eod::batch {
namespace {

class Batch : public testing::Test {
 protected:
  ShortExercise exercise_;
  ScratchFolder out_;
};

TEST_F(Batch, EveryRunEndsAsItsScriptExpects) {
  const Plan plan = exercise_.MakePlan();
  const BatchProgress progress = Drive(plan, 2, {}, 2, out_.path());
  EXPECT_EQ(progress.driven, 10u);
  EXPECT_EQ(progress.unexpected, 0u) << ReadText(out_ / "results.csv");
  const Summary summary =
      Summarise(BatchRun(ShippedGround(), RunsOf(plan, 2), RunsFolder(out_.path()), {}).records());
  EXPECT_EQ(summary.total.runs, 2);
  EXPECT_EQ(summary.total.drills_as_expected, 8);
}

TEST_F(Batch, OneThreadAndFourLeaveTheSameBytes) {
  const Plan plan = exercise_.MakePlan();
  Drive(plan, 4, {}, 1, out_ / "one");
  Drive(plan, 4, {}, 4, out_ / "four");
  EXPECT_EQ(ReadText(out_ / "one/results.csv"), ReadText(out_ / "four/results.csv"));
  EXPECT_EQ(ReadText(out_ / "one/summary.json"), ReadText(out_ / "four/summary.json"));
  for (const PlannedRun& run : RunsOf(plan, 4)) {
    const std::string file = "runs/" + run.name() + ".json";
    EXPECT_EQ(ReadText(out_ / "one" / file), ReadText(out_ / "four" / file));
  }
}

TEST_F(Batch, GoesOnWhereItWasLeft) {
  const Plan plan = exercise_.MakePlan();
  Drive(plan, 2, {}, 2, out_.path());
  const std::string before = ReadText(out_ / "results.csv");
  std::filesystem::remove(out_ / "runs/short.0001.json");
  std::filesystem::remove(out_ / "runs/short.late.0000.json");
  const BatchProgress progress = Drive(plan, 2, {}, 2, out_.path());
  EXPECT_EQ(progress.found, 8u);
  EXPECT_EQ(progress.driven, 2u);
  EXPECT_EQ(ReadText(out_ / "results.csv"), before);
}

TEST_F(Batch, DrivesAnewWhatOtherFilesMade) {
  Drive(exercise_.MakePlan(), 2, {}, 2, out_.path());
  exercise_.folder().Put("scripts/short.boxscript",
                         ShortExercise::kPowerUp + "speed creep\ndrive to 0 1 within 30s\n");
  EXPECT_EQ(Drive(exercise_.MakePlan(), 2, {}, 2, out_.path()).driven, 2u);
  const Plan plan = exercise_.MakePlan();
  Ground other = ShippedGround();
  other.inputs.world = "another";
  EXPECT_EQ(BatchRun(other, RunsOf(plan, 2), RunsFolder(out_.path()), {}).progress().found, 0u);
}

TEST_F(Batch, StoppedItKeepsWholeRunsAlone) {
  const Plan plan = exercise_.MakePlan();
  BatchRun dut(ShippedGround(), RunsOf(plan, 1000), RunsFolder(out_.path()), {});
  dut.Start(2);
  while (dut.progress().driven < 3) std::this_thread::yield();
  dut.Stop();
  dut.Join();
  const BatchProgress progress = dut.progress();
  EXPECT_LT(progress.driven, progress.planned);
  size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(RunsFolder(out_.path()))) {
    EXPECT_EQ(entry.path().extension(), ".json");
    ReadRecord(entry.path());
    ++files;
  }
  EXPECT_EQ(files, progress.driven);
}

TEST_F(Batch, AScenarioThatDoesNotFitTheWorldEndsTheBatchWithItsReason) {
  exercise_.folder().Put("scenarios/short.toml",
                         "name = \"short\"\nmodule = 1\n[[step]]\nkind = \"grasp\"\n"
                         "object = \"ghost\"\ntext = \"Take\"\n");
  const Plan plan = exercise_.MakePlan();
  BatchRun dut(ShippedGround(), RunsOf(plan, 2), RunsFolder(out_.path()), {});
  dut.Start(2);
  try {
    dut.Join();
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("short.toml"));
  }
}

TEST_F(Batch, NewsTellWhichRunWentWrongAndWhy) {
  exercise_.folder().Put("scripts/short.boxscript", ShortExercise::kPowerUp + "fail \"why not\"\n");
  const Plan plan = exercise_.MakePlan();
  BatchRun dut(ShippedGround(), RunsOf(plan, 1), RunsFolder(out_.path()), {});
  dut.Start(1);
  dut.Join();
  EXPECT_THAT(dut.TakeNews(),
              testing::ElementsAre("short repetition 0: script, expected success: "
                                   "short.boxscript:11: fail \"why not\": why not"));
  EXPECT_TRUE(dut.TakeNews().empty());
}

TEST(DrivenRun, IsTheSameAsInTheWholeWorld) {
  const std::filesystem::path data = EOD_DATA_DIR;
  const std::vector<std::string> only{"bomb_ground_m"};
  const Plan plan = MakePlan(data / "sim/scenarios", data / "firmware_emu/scripts", only);
  Ground whole = ShippedGround();
  // Module 3 first, and all others beside it.
  const sim::WorldModel world = sim::LoadWorld(data / "sim/worlds/training_ground.sdf");
  whole.worlds = {world};
  std::swap(whole.worlds[0].modules[0],
            *std::find_if(whole.worlds[0].modules.begin(), whole.worlds[0].modules.end(),
                          [](const auto& module) { return module.id == 3; }));
  const std::atomic<bool> never{false};
  for (const PlannedRun& run : RunsOf(plan, 1)) {
    const auto own = DriveRun(ShippedGround(), run, {}, never);
    EXPECT_TRUE(own->passes()) << TextOf(own->outcome) << ' ' << own->why;
    EXPECT_EQ(DriveRun(whole, run, {}, never), own);
  }
}

}  // namespace
}  // namespace eod::batch
