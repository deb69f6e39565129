#include "firmware_emu/condition.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/firmware_emu/box_rig.h"

namespace eod::box {
namespace {

class ConditionOn : public testing::Test {
 protected:
  bool Is(std::string_view text) const {
    WordReader words(text);
    const Condition condition = ParseCondition(words);
    words.RequireEnd();
    return Holds(condition, status_, odometer_);
  }
  std::string Seen(std::string_view text) const {
    WordReader words(text);
    return Observed(ParseCondition(words), status_, odometer_);
  }
  dbc::LampPattern& lamp(dbc::Lamp lamp) { return status_.lamp[static_cast<size_t>(lamp)]; }

  PanelStatus status_;
  Odometer odometer_;
};

std::string ErrorOf(std::string_view text) {
  try {
    WordReader words(text);
    ParseCondition(words);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(ConditionOn, LampsDistinguishesPatternsAndOnMeansAnyOfThem) {
  lamp(dbc::Lamp::kCollision) = dbc::LampPattern::kFastBlink;
  EXPECT_TRUE(Is("lamp collision on"));
  EXPECT_TRUE(Is("lamp collision fast"));
  EXPECT_FALSE(Is("lamp collision slow"));
  EXPECT_FALSE(Is("lamp collision off"));
  EXPECT_TRUE(Is("not lamp collision off"));
  EXPECT_TRUE(Is("lamp estop off"));
  EXPECT_TRUE(Is("lit collision off"));
}

TEST_F(ConditionOn, BuzzerAlarmAndInhibitedMotions) {
  EXPECT_TRUE(Is("buzzer off"));
  EXPECT_TRUE(Is("alarm none"));
  EXPECT_TRUE(Is("inhibit none"));
  status_.buzzer = dbc::BuzzerPattern::kFast;
  status_.feedback.alarm_code = 0x10;
  status_.feedback.inhibit_mask = 0b101;  // M01, M03
  EXPECT_TRUE(Is("buzzer on"));
  EXPECT_TRUE(Is("alarm any"));
  EXPECT_TRUE(Is("alarm 16"));
  EXPECT_FALSE(Is("alarm 17"));
  EXPECT_TRUE(Is("inhibit M01"));
  EXPECT_TRUE(Is("inhibit M01 M03"));
  EXPECT_FALSE(Is("inhibit M01 M02"));
  EXPECT_TRUE(Is("not inhibit M02"));
  EXPECT_FALSE(Is("inhibit none"));
}

TEST_F(ConditionOn, StatesOfBoxRobotMissionModuleAndLink) {
  status_.state = BoxState::kEstopLatched;
  status_.feedback.state = dbc::SystemState::kSafeStop;
  status_.feedback.mission_state = 3;
  status_.feedback.module = dbc::Module::kFlat;
  EXPECT_TRUE(Is("state estop"));
  EXPECT_TRUE(Is("robot safe_stop"));
  EXPECT_TRUE(Is("mission success"));
  EXPECT_TRUE(Is("module flat"));
  EXPECT_TRUE(Is("link down"));
  EXPECT_FALSE(Is("link up"));
}

TEST_F(ConditionOn, NumbersCompare) {
  status_.feedback.speed_mps = 0.3;
  status_.feedback.joint[0] = -1.5;
  status_.feedback.battery_soc = 0.8;
  EXPECT_TRUE(Is("speed >= 0.3"));
  EXPECT_TRUE(Is("speed <= 0.3"));
  EXPECT_FALSE(Is("speed > 0.3"));
  EXPECT_FALSE(Is("speed < 0.3"));
  EXPECT_TRUE(Is("joint 1 < -1"));
  EXPECT_TRUE(Is("battery > 79"));
}

TEST_F(ConditionOn, HeadingsCompareTheShortWayRound) {
  status_.feedback.heading_deg = 359.99;
  EXPECT_FALSE(Is("heading >= 88"));
  EXPECT_TRUE(Is("heading < 10"));
  status_.feedback.heading_deg = 88.01;
  EXPECT_TRUE(Is("heading >= 88"));
}

TEST_F(ConditionOn, TravelAndTurnCountFromTheRestart) {
  dbc::RobotFeedback robot;
  robot.heading_deg = 350;
  odometer_.Restart(At(seconds(10)), robot);
  robot.speed_mps = -0.5;
  robot.heading_deg = 20;
  odometer_.Update(At(seconds(12)), robot);
  EXPECT_NEAR(odometer_.travel_m(), -1.0, 1e-12);
  EXPECT_NEAR(odometer_.turned_deg(), 30, 1e-12);
  EXPECT_TRUE(Is("travel <= -1"));
  EXPECT_TRUE(Is("turned > 29"));
}

TEST_F(ConditionOn, ObservationsSayWhatIsThereInstead) {
  lamp(dbc::Lamp::kLink) = dbc::LampPattern::kSlowBlink;
  EXPECT_EQ(Seen("lamp link off"), "lamp link is slow");
  EXPECT_EQ(Seen("joint 2 > 5"), "joint 2 is 0.000");
  EXPECT_EQ(Seen("state ready"), "state is off");
  EXPECT_EQ(Seen("inhibit M01"), "inhibit mask is 0x000000");
  EXPECT_EQ(Seen("buzzer on"), "buzzer is off");
}

TEST(ConditionText, ErrorsNameTheWordAndWhatIsAllowed) {
  using testing::HasSubstr;
  EXPECT_THAT(ErrorOf("moon up"), HasSubstr("'moon': allowed: lamp, lit, buzzer"));
  EXPECT_THAT(ErrorOf("lamp disco on"), HasSubstr("'disco': allowed: power, link"));
  EXPECT_EQ(ErrorOf("lamp link green"), "'green': allowed: off, on, slow, fast");
  EXPECT_EQ(ErrorOf("speed = 3"), "'=': allowed: >=, <=, >, <");
  EXPECT_EQ(ErrorOf("speed > fast"), "'fast': allowed: a number");
  EXPECT_EQ(ErrorOf("joint 10 > 0"), "'10': allowed: a whole number 1..9");
  EXPECT_EQ(ErrorOf("alarm red"), "'red': allowed: a whole number 1..255");
  EXPECT_EQ(ErrorOf("link"), "'end of line': allowed: down, up");
}

}  // namespace
}  // namespace eod::box
