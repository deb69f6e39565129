#include "sim/score/report.h"

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "sim/score/score_json.h"
#include "sim/score/score_page.h"
#include "tests/unit/score/judged.h"

namespace eod::sim {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

/// A mission with something of everything.
ScoreSheet Eventful() {
  Scenario scenario = TwoSteps();
  scenario.title = "Charge & <can>";
  scenario.steps[1].text = "Put it \"away\"";
  scenario.steps[1].object = "can";
  scenario.precision.resize(1);
  scenario.precision[0].kind = PrecisionSpec::Kind::kTiltPeak;
  scenario.precision[0].worst = 1;
  scenario.procedure.resize(2);
  scenario.procedure[0].kind = ProcedureSpec::Kind::kLampTest;
  scenario.procedure[1].kind = ProcedureSpec::Kind::kLowSpeedWhileCarrying;
  Judged run(scenario);
  run.Drive(3);
  run.sample.contact_parts = 1;
  run.sample.contact_object = "wall";
  run.sample.wanted_mask = run.sample.blocked_mask = 1;
  run.Wait(2);
  run.CompleteStep();
  run.End(MissionState::kFail, FailReason::kTimeOut);
  return run.dut.Sheet();
}

std::string Text(const fs::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(Report, JsonHoldsEveryItemAndEvent) {
  const ScoreSheet sheet = Eventful();
  const nlohmann::json json = nlohmann::json::parse(ToJson(sheet));
  EXPECT_EQ(json["scenario"], "two_steps");
  EXPECT_EQ(json["module"], "yard");
  EXPECT_EQ(json["result"], "fail");
  EXPECT_EQ(json["critical_failure"], "time_out");
  EXPECT_EQ(json["passed"], false);
  EXPECT_EQ(json["total"].get<double>(), sheet.total);
  ASSERT_EQ(json["parts"].size(), 5u);
  double sum = 0;
  for (size_t i = 0; i < 5; ++i) {
    sum += json["parts"][i]["points"].get<double>();
    EXPECT_EQ(json["parts"][i]["items"].size(), sheet.parts[i].items.size());
  }
  EXPECT_DOUBLE_EQ(sum, sheet.total);
  EXPECT_TRUE(json["parts"][2]["items"][0]["amount"].is_null());  // never measured
  EXPECT_EQ(json["procedure"][0]["result"], "missing");
  EXPECT_EQ(json["procedure"][1]["result"], "kept");
  ASSERT_EQ(json["events"].size(), sheet.events.size());
  EXPECT_EQ(json["events"][0]["item"], "collision");
  EXPECT_EQ(json["events"][0]["text"], "Collision with wall");
  EXPECT_NEAR(json["events"][0]["y_m"].get<double>(), 3, 1e-9);
  EXPECT_EQ(json["events"].back()["text"], "Mission failed: time_out");
}

TEST(Report, PageShowsEveryItemEventAndCheck) {
  const ScoreSheet sheet = Eventful();
  const std::string page = ToPage(sheet);
  for (const ScorePart& part : sheet.parts) {
    EXPECT_THAT(page, HasSubstr(part.text));
    for (const ScoreItem& item : part.items) EXPECT_THAT(page, HasSubstr(EscapeHtml(item.text)));
  }
  for (const SheetEvent& event : sheet.events) {
    EXPECT_THAT(page, HasSubstr("<td>" + EscapeHtml(event.text) + "</td>"));
  }
  for (const SheetProcedure& line : sheet.procedure) EXPECT_THAT(page, HasSubstr(line.text));
  EXPECT_THAT(page, HasSubstr("NOT PASSED"));
  EXPECT_THAT(page, HasSubstr("Critical failure: time_out"));
  EXPECT_THAT(page, HasSubstr("Charge &amp; &lt;can&gt;"));
  EXPECT_THAT(page, HasSubstr("Put it &quot;away&quot;"));
  EXPECT_THAT(page, Not(HasSubstr("record lacks")));
}

/// Every element that is opened is closed, in the right order.
TEST(Report, PageIsWellFormed) {
  const std::string page = ToPage(Eventful());
  const std::set<std::string> empty{"meta", "br"};
  const std::regex tag("<(/?)([a-z0-9]+)((?:\"[^\"]*\"|[^\">])*?)(/?)>");
  std::vector<std::string> open;
  for (std::sregex_iterator it(page.begin(), page.end(), tag), end; it != end; ++it) {
    const std::string name = (*it)[2];
    if ((*it)[1] == "/") {
      ASSERT_FALSE(open.empty()) << name;
      ASSERT_EQ(open.back(), name) << it->position();
      open.pop_back();
    } else if ((*it)[4] != "/" && empty.count(name) == 0) {
      open.push_back(name);
    }
  }
  EXPECT_THAT(open, ::testing::IsEmpty());
}

TEST(Report, PageNeedsNothingFromElsewhereAndHasNoDate) {
  const std::string page = ToPage(Eventful());
  for (const char* word : {"http:", "https:", "src=", "<link", "<script", "url("}) {
    EXPECT_THAT(page, Not(HasSubstr(word)));
  }
  EXPECT_EQ(page, ToPage(Eventful()));
}

TEST(Report, MapMarksWherePointsWereWonAndLost) {
  const ScoreSheet sheet = Eventful();
  const std::string map = ToMap(sheet);
  EXPECT_THAT(map, HasSubstr(">can</text>"));
  size_t marks = 0, wanted = 0;
  for (size_t at = map.find("class=\"mark"); at != std::string::npos;
       at = map.find("class=\"mark", at + 1)) {
    ++marks;
  }
  for (const SheetEvent& event : sheet.events) {
    if (event.points != 0 || event.part == "failure") ++wanted;
  }
  EXPECT_EQ(marks, wanted);
  EXPECT_EQ(ToMap(ScoreSheet{}), "");
}

TEST(Report, SheetThatIsNotTheWholeRunSaysSo) {
  ScoreSheet sheet = Eventful();
  sheet.lost_s = 2.5;
  EXPECT_THAT(ToPage(sheet), HasSubstr("The record lacks 2.5 s of the mission"));
}

TEST(Report, BothFilesAreWrittenWholeAndTheFolderIsMade) {
  const fs::path folder =
      fs::path(::testing::TempDir()) / ("eod_report_" + std::to_string(getpid()));
  const ScoreSheet sheet = Eventful();
  WriteReport(sheet, folder / "deep");
  EXPECT_EQ(Text(folder / "deep/score.json"), ToJson(sheet));
  EXPECT_EQ(Text(folder / "deep/report.html"), ToPage(sheet));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "deep"), fs::directory_iterator{}), 2);
  std::ofstream(folder / "file") << "in the way";
  try {
    WriteReport(sheet, folder / "file");
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(),
                ::testing::StartsWith((folder / "file").string() + ": cannot be made"));
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace eod::sim
