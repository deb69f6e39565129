// The score of whole missions: live and from what was on LCM.
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lcm/lcm-cpp.hpp>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "programs/score_command.h"
#include "sim/score/report.h"
#include "tests/scenario/charge_script.h"

namespace eod::lockstep {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

std::string Text(const fs::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// A folder that goes with the test.
class Folder {
 public:
  Folder() { fs::create_directories(path_); }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  fs::path operator/(const char* name) const { return path_ / name; }

 private:
  fs::path path_ = fs::path(::testing::TempDir()) /
                   ("eod_score_" + std::to_string(getpid()) +
                    ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

/// Writes down all that a mission's parts say on LCM, as a recorder does.
class LcmLogger {
 public:
  LcmLogger(lcm::LCM& lcm, const fs::path& file) : log_(file.string(), "w") {
    lcm.subscribe(".*", &LcmLogger::Write, this);
  }
  void Write(const lcm::ReceiveBuffer* buffer, const std::string& channel) {
    lcm::LogEvent event{};
    event.timestamp = buffer->recv_utime;
    event.channel = channel;
    event.datalen = static_cast<int32_t>(buffer->data_size);
    event.data = buffer->data;
    log_.writeEvent(&event);
  }

 private:
  lcm::LogFile log_;
};

sim::ScoreOptions OptionsFor(const std::string& scenario, const fs::path& log,
                             const fs::path& out) {
  sim::ScoreOptions options;
  options.log = log;
  options.scenario = kData / "sim/scenarios" / (scenario + ".toml");
  options.out = out;
  return options;
}

struct Driven {
  std::string script, scenario;
};
class Score : public ::testing::TestWithParam<Driven> {};

/// What is in the log is all that the score needs.
TEST_P(Score, FromTheLogIsTheLiveOneToTheLastByte) {
  Folder folder;
  Mission dut(box::LoadScript(kData / "firmware_emu/scripts" / (GetParam().script + ".boxscript")),
              ShippedScenario(GetParam().scenario));
  {
    LcmLogger logger(dut.rig().lcm(), folder / "run.lcmlog");
    PlayScript(dut, 1800s);
  }
  const sim::ScoreSheet live = dut.rig().simulator().scorer().Sheet();
  WriteReport(live, folder / "live");
  RunScoreCommand(OptionsFor(GetParam().scenario, folder / "run.lcmlog", folder / "log"));
  EXPECT_EQ(Text(folder / "live/score.json"), Text(folder / "log/score.json"));
  EXPECT_EQ(Text(folder / "live/report.html"), Text(folder / "log/report.html"));
  EXPECT_EQ(live.result, "success");
  EXPECT_EQ(live.lost_s, 0);
  EXPECT_EQ(live.steps_done, live.steps);
  EXPECT_DOUBLE_EQ(live.parts[0].points, live.parts[0].of);
  EXPECT_TRUE(live.passed) << Text(folder / "live/score.json");
  double sum = 0;
  for (const sim::ScorePart& part : live.parts) {
    EXPECT_GE(part.points, 0) << part.name;
    EXPECT_LE(part.points, part.of) << part.name;
    sum += part.points;
  }
  EXPECT_DOUBLE_EQ(sum, live.total);
  EXPECT_DOUBLE_EQ(dut.rig().simulator().last().task.score, live.total);
}

INSTANTIATE_TEST_SUITE_P(Missions, Score,
                         ::testing::Values(Driven{"first_drive", "flat_first_drive"},
                                           Driven{"slope_ramps", "slope_ramps"},
                                           Driven{"slope_stairs", "slope_stairs"},
                                           Driven{"bomb_ground", "bomb_ground_m"},
                                           Driven{"bomb_table", "bomb_table_s"},
                                           Driven{"bomb_bench", "bomb_bench_l"},
                                           Driven{"bomb_chamber", "bomb_chamber_m"}),
                         [](const auto& mission) { return mission.param.scenario; });

}  // namespace
}  // namespace eod::lockstep
