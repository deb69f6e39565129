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
    return Holds(condition, status_, odometer_, sight_);
  }
  std::string Seen(std::string_view text) const {
    WordReader words(text);
    return Observed(ParseCondition(words), status_, odometer_, sight_);
  }
  dbc::LampPattern& lamp(dbc::Lamp lamp) { return status_.lamp[static_cast<size_t>(lamp)]; }

  PanelStatus status_;
  Odometer odometer_;
  const Sight* sight_ = nullptr;
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
  dbc::RobotFeedback& robot = status_.feedback;
  robot.heading_deg = 350;
  status_.pose_time = At(seconds(10));
  odometer_.Restart(At(seconds(10)), status_);
  robot.speed_mps = -1;
  robot.heading_deg = 20;
  status_.pose_time = At(seconds(12));
  odometer_.Update(At(seconds(12)), status_);
  EXPECT_NEAR(odometer_.travel_m(), -1.0, 1e-12) << "from rest to -1 m/s in 2 s";
  EXPECT_NEAR(odometer_.turned_deg(), 30, 1e-12);
  EXPECT_TRUE(Is("travel <= -1"));
  EXPECT_TRUE(Is("turned > 29"));
}

TEST_F(ConditionOn, GraspBombFireReasonAndFailureByTheirWords) {
  const auto check = [this](std::string_view subject, const std::vector<std::string>& words,
                            auto set) {
    for (int i = 0; i < static_cast<int>(words.size()); ++i) {
      set(i);
      for (const std::string& word : words) {
        EXPECT_EQ(Is(std::string(subject) + " " + word), word == words[i]) << word;
      }
    }
  };
  check("grasp",
        {"open", "closing", "contact_left", "contact_right", "contact_both", "grasped", "slipping",
         "released"},
        [this](int i) { status_.feedback.grasp_state = i; });
  check("bomb",
        {"none", "placed", "touched", "tilted", "grasped", "carried", "dropped", "in_can",
         "exploded", "disrupted"},
        [this](int i) { status_.feedback.bomb_state = i; });
  check("fire", {"safe", "armed_wait", "ready", "fired", "fault", "time_out"},
        [this](int i) { status_.feedback.fire_state = i; });
  check("reason",
        {"none", "collision", "joint_limit", "conflict", "deadman", "link_loss", "estop", "payload",
         "tilt", "neutral_needed", "not_ready", "cable"},
        [this](int i) { status_.feedback.inhibit_reason = static_cast<dbc::InhibitReason>(i); });
  check("failure",
        {"none", "exploded", "time_out", "rollover", "out_of_area", "link_lost", "estop",
         "instructor", "bomb_lost", "wrong_order"},
        [this](int i) { status_.feedback.fail_reason = i; });
  EXPECT_TRUE(Is("not grasp slipping"));
  EXPECT_EQ(Seen("grasp grasped"), "grasp is released");
  EXPECT_EQ(Seen("reason none"), "reason is cable");
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
  EXPECT_EQ(ErrorOf("fire hot"), "'hot': allowed: safe, armed_wait, ready, fired, fault, time_out");
  EXPECT_EQ(ErrorOf("link"), "'end of line': allowed: down, up");
}

class ConditionByEye : public ConditionOn {
 protected:
  ConditionByEye() {
    // It looks along -X; the can is 3 m ahead and 1 m to the right.
    scene_.position = {2, 5, 0.1};
    scene_.heading_deg = 90;
    scene_.objects = {{.name = "can", .position = {-1, 6, 0.4}},
                      {.name = "box", .position = {2, 5, 0}, .tilt_deg = 30},
                      {.name = "shot", .is_gone = true}};
    sight_ = &scene_;
  }
  Sight scene_;
};

TEST_F(ConditionByEye, KnowsWhereTheRobotIs) {
  EXPECT_TRUE(Is("x >= 2"));
  EXPECT_FALSE(Is("y < 5"));
  EXPECT_TRUE(Is("not z > 0.2"));
  EXPECT_EQ(Seen("y < 5"), "y is 5.000");
}

TEST_F(ConditionByEye, KnowsWhereThingsAreFromTheRobot) {
  EXPECT_EQ(Seen("ahead can > 9"), "ahead can is 3.000");
  EXPECT_EQ(Seen("side can > 9"), "side can is 1.000");
  EXPECT_EQ(Seen("distance can > 9"), "distance can is 3.162");
  EXPECT_EQ(Seen("height can > 9"), "height can is 0.400");
  EXPECT_TRUE(Is("tilt box >= 30"));
  EXPECT_TRUE(Is("seen box"));
  EXPECT_FALSE(Is("not seen box"));
}

TEST_F(ConditionByEye, DoesNotHoldOfWhatIsNotSeen) {
  for (const char* text : {"distance shot < 9", "not distance shot < 9", "distance ghost < 9"}) {
    EXPECT_FALSE(Is(text)) << text;
  }
  EXPECT_TRUE(Is("not seen shot"));
  EXPECT_EQ(Seen("tilt ghost > 1"), "'ghost' is not seen; seen are can, box");
}

TEST_F(ConditionByEye, DoesNotHoldWithoutEyes) {
  sight_ = nullptr;
  EXPECT_FALSE(Is("x > -100"));
  EXPECT_FALSE(Is("not seen shot"));
  EXPECT_THAT(Seen("x > -100"), testing::HasSubstr("sees nothing"));
}

}  // namespace
}  // namespace eod::box
