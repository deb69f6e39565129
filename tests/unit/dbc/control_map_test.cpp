#include "dbc/control_map.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dbc/nearest_name.h"
#include "tests/unit/dbc/samples.h"

namespace eod::dbc {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

/// The shipped map with one piece of text replaced, as a file for the length of a test.
class EditedMap {
 public:
  EditedMap(const std::string& from, const std::string& to)
      : file_(std::filesystem::path(testing::TempDir()) /
              (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) +
               ".map.toml")) {
    std::ifstream stream(ShippedMapFile());
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    line_ = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at + to.size()),
                           '\n');
    std::ofstream(file_) << text;
  }
  ~EditedMap() { std::filesystem::remove(file_); }
  EditedMap(const EditedMap&) = delete;
  EditedMap& operator=(const EditedMap&) = delete;

  /// Error of LoadControlMap, without "FILE:LINE: ", which is checked to be that of the edit.
  std::string Error() const {
    return WithoutPlace(ErrorOf([&] { LoadControlMap(file_); }));
  }
  std::string ErrorAnywhere() const {
    return ErrorOf([&] { LoadControlMap(file_); });
  }
  /// The same of the codec, with the shipped DBC.
  std::string CodecError() const {
    ControlMap map = LoadControlMap(file_);
    const Database database = LoadDatabase(ShippedMapFile().parent_path() / map.dbc.filename());
    return WithoutPlace(ErrorOf([&] { BoxCodec(database, map); }));
  }
  ControlMap Load() const { return LoadControlMap(file_); }

 private:
  std::string WithoutPlace(const std::string& error) const {
    const std::string place = file_.string() + ":" + std::to_string(line_) + ": ";
    EXPECT_THAT(error, StartsWith(place));
    EXPECT_EQ(error.find('\n'), std::string::npos);
    return error.size() > place.size() ? error.substr(place.size()) : error;
  }

  std::filesystem::path file_;
  std::ptrdiff_t line_ = 0;
};

TEST(ControlMap, ShippedOneHasEveryRole) {
  const ControlMap dut = LoadControlMap(ShippedMapFile());
  EXPECT_EQ(dut.controls.size() + kAxisCount, PanelRoles().size());
  EXPECT_EQ(dut.displays.size(), FeedbackRoles().size());
  EXPECT_EQ(dut.box_messages.size(), static_cast<size_t>(kBoxMessageCount));
  EXPECT_EQ(dut.robot_messages.size(), static_cast<size_t>(kRobotMessageCount));
  EXPECT_EQ(dut.dbc.filename(), "control_box.dbc");
}

TEST(ControlMap, ShippedOneHasEveryAlarm) {
  const ControlMap dut = LoadControlMap(ShippedMapFile());
  std::vector<int> codes;
  for (const AlarmMap& alarm : dut.alarms) codes.push_back(alarm.code);
  // domain.md 6.2; 0x90 is for the instructor's log only
  EXPECT_THAT(codes,
              ElementsAre(0x10, 0x11, 0x20, 0x30, 0x31, 0x40, 0x41, 0x42, 0x50, 0x60, 0x70, 0x80));
  EXPECT_EQ(dut.FindAlarm(0x10)->lamp, Lamp::kCollision);
  EXPECT_EQ(dut.FindAlarm(0x10)->pattern, LampPattern::kFastBlink);
  EXPECT_EQ(dut.FindAlarm(0x10)->buzzer, BuzzerPattern::kFast);
  EXPECT_EQ(dut.FindAlarm(0x20)->lamp, Lamp::kLimit);
  EXPECT_EQ(dut.FindAlarm(0x20)->pattern, LampPattern::kOn);
  EXPECT_EQ(dut.FindAlarm(0x20)->buzzer, BuzzerPattern::kBeep);
  EXPECT_EQ(dut.FindAlarm(0x90), nullptr);
}

TEST(ControlMap, ShippedSticksDriveAsThePanelIsLabelled) {
  const ControlMap dut = LoadControlMap(ShippedMapFile());
  const auto pair = [&](size_t axis, ControlMode mode) {
    for (const auto& p : dut.axes[axis].motions) {
      if (p.mode == mode) return std::pair(p.positive, p.negative);
    }
    return std::pair(0, 0);
  };
  EXPECT_EQ(pair(0, ControlMode::kDrive), std::pair(1, 2));  // forward, backward
  EXPECT_EQ(pair(1, ControlMode::kDrive), std::pair(4, 3));  // right stick is a right turn
  EXPECT_EQ(pair(2, ControlMode::kArm), std::pair(9, 10));   // big arm up, down
  EXPECT_EQ(pair(0, ControlMode::kCamera), std::pair(0, 0));
  for (const AxisMap& axis : dut.axes) EXPECT_EQ(axis.dead_zone, 0.05);
}

TEST(ControlMap, NamesTheNearestKeyOfAnUnknownOne) {
  EXPECT_EQ(EditedMap("horn =", "hron =").Error(),
            "[controls]: unknown key \"hron\"; did you mean \"horn\"?");
  EXPECT_EQ(EditedMap("[lamps]", "[lambs]").Error(),
            "the map: unknown key \"lambs\"; did you mean \"lamps\"?");
  EXPECT_EQ(EditedMap("SlowBlink\"\nfast_blink", "SlowBlink\"\nfastblink").Error(),
            "[labels.lamp]: unknown key \"fastblink\"; did you mean \"fast_blink\"?");
}

TEST(ControlMap, RefusesAMissingRole) {
  const EditedMap map("horn = \"BOX_PANEL.Horn\"\n", "");
  // The place is that of the table that lacks the key.
  EXPECT_THAT(map.ErrorAnywhere(), EndsWith(": [controls]: \"horn\" is missing"));
}

TEST(ControlMap, RefusesBadValues) {
  EXPECT_EQ(EditedMap("dead_zone = 0.05", "dead_zone = 0.6").Error(),
            "dead_zone = 0.6, allowed 0..0.5");
  EXPECT_EQ(EditedMap("dead_zone = 0.05", "dead_zone = \"x\"").Error(),
            "dead_zone: must be a number 0..0.5");
  EXPECT_EQ(EditedMap("positive = \"M01\"", "positive = \"M23\"").Error(),
            "positive = \"M23\", allowed: M01..M22, none");
  EXPECT_EQ(EditedMap("horn = \"BOX_PANEL.Horn\"", "horn = \"Horn\"").Error(),
            "horn = \"Horn\", allowed: \"MESSAGE.SIGNAL\" or \"none\"");
  EXPECT_EQ(EditedMap("deadman = \"BOX_SAFETY.Deadman\"", "deadman = \"none\"").Error(),
            "deadman = \"none\": no box can do without it");
  EXPECT_EQ(EditedMap("M05 = \"BOX_MOTION.M05_FrontFlipUp\"", "M05 = \"none\"").Error(),
            "M05 = \"none\": no box can do without it");
  EXPECT_EQ(
      EditedMap("horn = \"BOX_PANEL.Horn\"", "horn = { signal = \"BOX_PANEL.Horn\", inverted = 1 }")
          .Error(),
      "inverted: must be true or false");
  EXPECT_THAT(
      EditedMap("code = 0x10, lamp = \"collision\"", "code = 0x10, lamp = \"colision\"").Error(),
      StartsWith("lamp = \"colision\", allowed: power, link, "));
  EXPECT_THAT(EditedMap("code = 0x10", "code = 256").Error(), HasSubstr("allowed 1..255"));
  EXPECT_THAT(EditedMap("code = 0x10", "code = 0x11").Error(), HasSubstr("the same code 0x11"));
}

TEST(ControlMap, RefusesBrokenTomlAndMissingFiles) {
  EXPECT_THAT(ErrorOf([] { LoadControlMap("no/such.map.toml"); }),
              StartsWith("no/such.map.toml:1: cannot be read"));
  EXPECT_THAT(EditedMap("horn = \"BOX_PANEL.Horn\"", "horn = = 1").Error(), HasSubstr("value"));
}

TEST(ControlMap, TakesABoxWithoutAHorn) {
  const ControlMap dut = EditedMap("horn = \"BOX_PANEL.Horn\"", "horn = \"none\"").Load();
  EXPECT_EQ(dut.controls.at("horn").message, "");
  EXPECT_NO_THROW(BoxCodec(LoadDatabase(ShippedMapFile().parent_path() / "control_box.dbc"), dut));
}

TEST(ControlMap, NamesWhatTheDbcDoesNotHave) {
  EXPECT_THAT(EditedMap("panel = \"BOX_PANEL\"", "panel = \"BOX_PANNEL\"").CodecError(),
              HasSubstr("did you mean \"BOX_PANEL\"?"));
  EXPECT_EQ(EditedMap("BOX_PANEL.Horn", "BOX_PANEL.Hron").CodecError(),
            "horn = \"BOX_PANEL.Hron\": the message has no such signal; did you mean \"Horn\"?");
  EXPECT_EQ(EditedMap("arm_key = { signal = \"BOX_FIRE.ArmKey\", labels = { fault = \"Fault0\"",
                      "arm_key = { signal = \"BOX_FIRE.ArmKey\", labels = { fault = \"Foult0\"")
                .CodecError(),
            "arm_key: signal ArmKey has no label \"Foult0\"; did you mean \"Fault0\"?");
  EXPECT_EQ(EditedMap("supply = \"BOX_SAFETY.BoxSupply\"", "supply = \"BOX_SAFETY.SpeedLimit\"")
                .CodecError(),
            "supply: signal SpeedLimit has the unit \"%\", allowed: \"V\", \"mV\"");
  EXPECT_EQ(EditedMap("listen = \"BOX_PANEL.Listen\"", "listen = \"BOX_PANEL.Ptt\"").CodecError(),
            "listen = \"BOX_PANEL.Ptt\": its bits are those of another signal of the map");
  EXPECT_EQ(EditedMap("speed = \"ROB_POSE.Speed\"", "speed = \"BOX_PANEL.Horn\"").CodecError(),
            "speed = \"BOX_PANEL.Horn\": the message is not in [messages] of this direction");
}

TEST(NearestName, PrefersFewEditsAndForgivesCase) {
  EXPECT_EQ(NearestName("hron", {"light", "horn", "listen"}), "horn");
  EXPECT_EQ(NearestName("OPERATE", {"Standby", "Operate"}), "Operate");
  EXPECT_EQ(NearestName("x", {}), "");
}

}  // namespace
}  // namespace eod::dbc
