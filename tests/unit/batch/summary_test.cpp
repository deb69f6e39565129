#include "batch/summary.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "batch/confidence.h"
#include "tests/unit/batch/scratch_folder.h"

namespace eod::batch {
namespace {

using Kind = Outcome::Kind;

RunRecord Record(const std::string& scenario, uint64_t repetition, const Outcome& outcome,
                 const Outcome& expected = {}) {
  return {.scenario = scenario,
          .script = expected == Outcome{} ? scenario : scenario + ".drill",
          .repetition = repetition,
          .inputs = {},
          .expected = expected,
          .outcome = outcome,
          .score = outcome == Outcome{} ? 90.0 : 40.0,
          .elapsed_s = 100 + static_cast<double>(repetition),
          .simulated_s = 120,
          .collisions = 2,
          .steps_done = 3,
          .steps = 5,
          .why = ""};
}

const Outcome kExploded{Kind::kFailure, sim::FailReason::kExploded};

std::vector<RunRecord> Records() {
  std::vector<RunRecord> records;
  for (uint64_t repetition = 0; repetition < 14; ++repetition) {
    records.push_back(Record("bomb", repetition, repetition == 3 ? kExploded : Outcome{}));
  }
  records.push_back(Record("bomb", 0, kExploded, kExploded));
  records.push_back(Record("bomb", 1, Outcome{}, kExploded));
  records.push_back(Record("ramp", 0, {.kind = Kind::kScript}));
  records.back().why = "ramp.boxscript:3: wait link up, \"soon\"";
  SortRecords(records);
  return records;
}

TEST(Summary, CountsSuccessesAndDrillsApart) {
  const Summary dut = Summarise(Records());
  ASSERT_EQ(dut.scenarios.size(), 2u);
  const ScenarioSummary& bomb = dut.scenarios[0];
  EXPECT_EQ(bomb.scenario, "bomb");
  EXPECT_EQ(bomb.runs, 14);
  EXPECT_EQ(bomb.successes, 13);
  EXPECT_DOUBLE_EQ(bomb.rate, 13.0 / 14);
  EXPECT_EQ(bomb.lower_bound, LowerBound(13, 14, kConfidence));
  EXPECT_TRUE(bomb.allows_claim);
  EXPECT_DOUBLE_EQ(bomb.mean_score, (13 * 90.0 + 40) / 14);
  EXPECT_DOUBLE_EQ(bomb.mean_elapsed_s, 106.5);
  EXPECT_EQ(bomb.collisions, 28);
  EXPECT_EQ(bomb.drills, 2);
  EXPECT_EQ(bomb.drills_as_expected, 1);
  EXPECT_EQ(dut.scenarios[1].successes, 0);
  EXPECT_EQ(dut.total.runs, 15);
  EXPECT_EQ(dut.unexpected, 3);
}

TEST(Summary, TheCsvHasALineARun) {
  const std::string csv = ToCsv(Records());
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 17);
  EXPECT_THAT(
      csv, testing::HasSubstr("\nbomb,bomb,3,success,failure,0,40.00,103.000,2,exploded,3,5,\n"));
  EXPECT_THAT(csv, testing::HasSubstr(
                       "\nbomb,bomb.drill,0,failure exploded,failure,1,40.00,100.000,2,exploded,"));
  EXPECT_TRUE(
      csv.ends_with("ramp,ramp,0,success,script,0,40.00,100.000,2,none,3,5,"
                    "\"ramp.boxscript:3: wait link up, \"\"soon\"\"\"\n"));
}

TEST(Summary, TheJsonSaysTheSame) {
  const auto json = nlohmann::json::parse(ToJson(Summarise(Records())));
  EXPECT_EQ(json["unexpected"], 3);
  EXPECT_EQ(json["scenarios"][0]["successes"], 13);
  EXPECT_EQ(json["total"]["drills"], 2);
}

TEST(Summary, TheTableHasALineAScenario) {
  const std::string table = ToTable(Summarise(Records()));
  EXPECT_THAT(table, testing::HasSubstr("\nbomb "));
  EXPECT_THAT(table, testing::HasSubstr("13 of 14"));
  EXPECT_THAT(table, testing::HasSubstr("1 of 2"));
  EXPECT_THAT(table, testing::HasSubstr("\ntotal "));
}

TEST(Record, ReadsAsItIsWritten) {
  const ScratchFolder folder;
  for (RunRecord record : Records()) {
    record.elapsed_s = 1.0 / 3;
    record.inputs.world = "0123";
    EXPECT_EQ(ReadRecord(folder.Put("a.json", ToJson(record))), record);
  }
}

TEST(Record, IsRefusedWhenItIsNone) {
  const ScratchFolder folder;
  for (const char* text : {"", "{}", "[1]", "{\"scenario\": 3}"}) {
    try {
      ReadRecord(folder.Put("a.json", text));
      FAIL() << text;
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("a.json: no record of a run: "));
    }
  }
}

}  // namespace
}  // namespace eod::batch
