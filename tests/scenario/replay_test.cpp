#include "lockstep/replay.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/scenario/mission.h"

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

/// Columns time to j9 of a line, without the step number: where the robot was, and when.
std::string TimeAndPose(const std::string& line) {
  const size_t start = line.find(',') + 1;
  size_t end = start;
  // time, module, x, y, z, heading, pitch, roll and nine joints.
  for (int column = 0; column < 17; ++column) end = line.find(',', end) + 1;
  return line.substr(start, end - start);
}

std::string LastLine(const std::string& text) {
  const size_t end = text.size() - 1;
  const size_t start = text.rfind('\n', end - 1) + 1;
  return text.substr(start, end - start);
}

class Replay : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              ("eod_replay_" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
               ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    config_.rig = Mission::ShippedRig();
    config_.can_log = folder_ / "in.log";
    config_.out = folder_ / "out";
  }
  void TearDown() override { fs::remove_all(folder_); }

  void Run() { ReplayLog(config_, data_.robot, data_.world, data_.scenario); }
  void WriteLog(const std::string& text) { std::ofstream(config_.can_log) << text; }
  std::string Failure() {
    try {
      Run();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
  ReplayConfig config_;
  const Shipped& data_ = ShippedData();
};

TEST_F(Replay, OfARecordedMissionMeetsTheSamePoseAtTheSameTimeAndTwiceGivesTheSameBytes) {
  Mission mission(kData / "firmware_emu/scripts/wall_stop.boxscript");
  ASSERT_TRUE(mission.Run(60s));
  WriteLog(mission.can_log());
  Run();
  const std::string states = Text(config_.out / "states.csv");
  const std::string can = Text(config_.out / "can.log");
  EXPECT_THAT(states, ::testing::HasSubstr(TimeAndPose(LastLine(mission.states()))));
  EXPECT_THAT(can, ::testing::HasSubstr(" 2A0#"));
  EXPECT_THAT(can, ::testing::Not(::testing::HasSubstr(" 190#")));
  const auto result = nlohmann::json::parse(Text(config_.out / "result.json"));
  EXPECT_EQ(result["scenario"], data_.scenario.name);
  ASSERT_FALSE(result["alarms"].empty());
  EXPECT_EQ(result["alarms"][0]["code"], 0x10);

  config_.out = folder_ / "again";
  Run();
  EXPECT_TRUE(Text(config_.out / "states.csv") == states);
  EXPECT_TRUE(Text(config_.out / "can.log") == can);
}

TEST_F(Replay, NamesTheLineOfABrokenLogAndWritesNothing) {
  WriteLog("(0.000000) vcan0 190#98200511C8007810\nnonsense\n");
  EXPECT_THAT(Failure(), ::testing::HasSubstr("in.log:2"));
  EXPECT_FALSE(fs::exists(config_.out));
}

TEST_F(Replay, RefusesALogWithoutABoxOrWithTimeGoingBack) {
  WriteLog("(0.000000) vcan0 2A0#0000000000000000\n");
  EXPECT_THAT(Failure(), ::testing::HasSubstr("no frame from a control box"));
  WriteLog("(2.000000) vcan0 710#05\n(1.000000) vcan0 710#05\n");
  EXPECT_THAT(Failure(), ::testing::HasSubstr("go back"));
  EXPECT_FALSE(fs::exists(config_.out));
}

TEST_F(Replay, SurvivesFramesOfStrangersOnTheBus) {
  WriteLog("(0.000000) vcan0 710#05\n(0.010000) vcan0 12345678#0102\n(0.020000) vcan0 190#00\n");
  Run();
  EXPECT_EQ(nlohmann::json::parse(Text(config_.out / "result.json"))["result"], "incomplete");
}

}  // namespace
}  // namespace eod::lockstep
