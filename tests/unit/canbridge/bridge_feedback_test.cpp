// Robot to box: state and alarms in, frames out.
#include <algorithm>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "platform/candump_log.h"
#include "tests/unit/canbridge/bridge_rig.h"

namespace eod::bridge {
namespace {

using dbc::BuzzerPattern;
using dbc::InhibitReason;
using dbc::Lamp;
using dbc::LampPattern;
using dbc::RobotMessage;
using dbc::SystemState;

constexpr uint32_t kFrontWheels = 0b11;  // FL and FR

TEST(BridgeFeedback, CollisionOfTheFrontWheelsGivesTheGoldenAlarmFrame) {
  BridgeRig rig;
  // ROB_ALARM so far: at 1 ms (power), 8 ms (cycle), 20 ms (link), 58 and 108 ms: counters 0 to 4.
  rig.Run(milliseconds(120));
  rig.Forget();
  rig.Alarm({{0x10, kFrontWheels}});
  ASSERT_EQ(rig.sent.size(), 1U) << "in the call that took the alarm";
  // Fast buzzer, power, link on, collision fast blink, FL and FR, code 0x10, counter 5.
  EXPECT_EQ(FormatCandumpLine(rig.sent[0].frame, "vcan0").substr(18),
            ") vcan0 2A0#8835050300300010");
}

TEST(BridgeFeedback, ClearedAlarmIsShownAtOnceToo) {
  BridgeRig rig;
  rig.Run(milliseconds(120));
  rig.Alarm({{0x10, kFrontWheels}});
  rig.Run(milliseconds(15));
  rig.Forget();
  rig.Alarm({});
  ASSERT_EQ(rig.sent.size(), 1U);
  EXPECT_EQ(rig.lamp(Lamp::kCollision), LampPattern::kOff);
  EXPECT_EQ(rig.shown.buzzer, BuzzerPattern::kOff);
  EXPECT_EQ(rig.shown.hit_parts, 0U);
  EXPECT_EQ(rig.shown.alarm_code, 0);
}

TEST(BridgeFeedback, ChangeMayFollowACyclicFrameAtOnce) {
  BridgeRig rig;
  rig.Run(milliseconds(158));  // ROB_ALARM's cycle: 1 + 7 + 3 * 50 ms
  ASSERT_EQ(rig.SentAs(RobotMessage::kAlarm).back().time, rig.now);
  rig.Forget();
  rig.Alarm({{0x10, kFrontWheels}});
  EXPECT_EQ(rig.SentAs(RobotMessage::kAlarm).size(), 1U);
}

TEST(BridgeFeedback, TwoChangesAreTenMillisecondsApart) {
  BridgeRig rig;
  rig.Run(milliseconds(120));
  rig.Forget();
  rig.Alarm({{0x10, kFrontWheels}});  // sent at 120 ms
  rig.Run(milliseconds(1));
  rig.Alarm({});
  rig.Run(milliseconds(8));
  EXPECT_EQ(rig.SentAs(RobotMessage::kAlarm).size(), 1U) << "129 ms: still waiting";
  rig.Run(milliseconds(1));
  ASSERT_EQ(rig.SentAs(RobotMessage::kAlarm).size(), 2U) << "130 ms";
  EXPECT_EQ(rig.lamp(Lamp::kCollision), LampPattern::kOff);
}

TEST(BridgeFeedback, FlickeringAlarmKeepsTheGapAndEndsRight) {
  BridgeRig rig;
  rig.Run(milliseconds(120));
  rig.Forget();
  for (int i = 0; i < 500; ++i) {
    if (i % 2 == 0) {
      rig.Alarm({{0x10, kFrontWheels}});
    } else {
      rig.Alarm({});
    }
    rig.Run(milliseconds(1));
  }
  // Cyclic ROB_ALARM frames come at 8 ms + k * 50 ms.
  TimePoint last_change{};
  for (const BridgeRig::Sent& each : rig.SentAs(RobotMessage::kAlarm)) {
    if (each.time.time_since_epoch() % milliseconds(50) == milliseconds(8)) continue;
    EXPECT_GE(each.time - last_change, milliseconds(10));
    last_change = each.time;
  }
  rig.Run(milliseconds(10));
  EXPECT_EQ(rig.lamp(Lamp::kCollision), LampPattern::kOff);
}

TEST(BridgeFeedback, InhibitedMotionIsShownAtOnce) {
  BridgeRig rig;
  rig.BringUp();
  rig.Run(milliseconds(3));
  rig.Forget();
  RobotReport report;
  report.inhibit_mask = 0b1;
  report.inhibit_reason = InhibitReason::kCollision;
  rig.Report(report);
  ASSERT_EQ(rig.SentAs(RobotMessage::kStatus).size(), 1U);
  EXPECT_EQ(rig.shown.inhibit_mask, 0b1U);
  EXPECT_EQ(rig.shown.inhibit_reason, InhibitReason::kCollision);
}

TEST(BridgeFeedback, InhibitsOfBridgeAndSimulatorAddUpAndTheGravestReasonIsShown) {
  BridgeRig rig;
  rig.BringUp();
  rig.Hold(9);
  rig.Hold(10);  // conflict of the big arm: bits 8 and 9
  rig.robot.inhibit_mask = 0b1;
  rig.robot.inhibit_reason = InhibitReason::kCollision;
  rig.Run(milliseconds(40));
  EXPECT_EQ(rig.shown.inhibit_mask, 0b11'0000'0001U);
  EXPECT_EQ(rig.shown.inhibit_reason, InhibitReason::kCollision) << "graver than a conflict";
  rig.robot.inhibit_reason = InhibitReason::kNone;
  rig.robot.inhibit_mask = 0;
  rig.Run(milliseconds(40));
  EXPECT_EQ(rig.shown.inhibit_reason, InhibitReason::kConflict);
}

TEST(BridgeFeedback, PayloadAndTiltOfTheSimulatorReachTheBoxAndRankBelowTheEmergencyStop) {
  for (const InhibitReason reason : {InhibitReason::kPayload, InhibitReason::kTilt}) {
    BridgeRig rig;
    rig.BringUp();
    rig.Hold(9);
    rig.Hold(10);  // conflict: less grave
    rig.robot.inhibit_mask = 0b1'0000'0000;
    rig.robot.inhibit_reason = reason;
    rig.Run(milliseconds(40));
    EXPECT_EQ(rig.shown.inhibit_reason, reason);
    rig.panel.estop_a = false;
    rig.panel.estop_b = true;
    rig.Run(milliseconds(40));
    EXPECT_EQ(rig.shown.inhibit_reason, InhibitReason::kEstop);
  }
  EXPECT_EQ(Gravest(InhibitReason::kPayload, InhibitReason::kTilt), InhibitReason::kTilt);
  EXPECT_EQ(Gravest(InhibitReason::kPayload, InhibitReason::kCollision), InhibitReason::kPayload);
}

TEST(BridgeFeedback, EveryMessageKeepsItsCycleForTenSecondsAndNoTwoShareAMillisecond) {
  BridgeRig rig;
  rig.BringUp();
  rig.Run(milliseconds(200));
  rig.Forget();
  rig.Run(std::chrono::seconds(10));
  // Cycle times of the DBC; emergency is sent on events only.
  const std::map<RobotMessage, int> cycle_ms{
      {RobotMessage::kStatus, 50},    {RobotMessage::kAlarm, 50},    {RobotMessage::kJointA, 50},
      {RobotMessage::kJointB, 50},    {RobotMessage::kJointC, 50},   {RobotMessage::kPose, 50},
      {RobotMessage::kBattery, 500},  {RobotMessage::kMission, 200}, {RobotMessage::kFire, 50},
      {RobotMessage::kHeartbeat, 200}};
  std::size_t sum = 0;
  for (const auto& [role, cycle] : cycle_ms) {
    const std::vector<BridgeRig::Sent> frames = rig.SentAs(role);
    ASSERT_EQ(frames.size(), static_cast<std::size_t>(10'000 / cycle)) << rig.IdOf(role);
    for (std::size_t i = 1; i < frames.size(); ++i) {
      ASSERT_EQ(frames[i].time - frames[i - 1].time, milliseconds(cycle)) << rig.IdOf(role);
    }
    sum += frames.size();
  }
  EXPECT_EQ(rig.sent.size(), sum);
  std::set<TimePoint> times;
  for (const BridgeRig::Sent& each : rig.sent) times.insert(each.time);
  EXPECT_EQ(times.size(), sum);
}

TEST(BridgeFeedback, HeldUpBridgeDoesNotCatchUpInABurst) {
  BridgeRig rig;
  rig.BringUp();
  rig.now += std::chrono::seconds(1);
  rig.Forget();
  rig.Run(milliseconds(1));
  EXPECT_LE(rig.SentAs(RobotMessage::kPose).size(), 1U);
}

TEST(BridgeFeedback, RobotStateIsShownInTheBoxesUnits) {
  BridgeRig rig;
  rig.robot.module = 1;
  rig.robot.heading_deg = 123.45;
  rig.robot.pitch_deg = -12.5;
  rig.robot.roll_deg = 3.5;
  rig.robot.speed_mps = -0.67;
  rig.robot.joint = {90, -45, 120, 30, -100, 179.99, 0.0805, -170, 12.34};
  rig.robot.limit_flags = 0b1'0000'0101;
  rig.robot.grasp_state = 4;
  rig.robot.battery_v = 25.61;
  rig.robot.battery_soc = 0.875;
  rig.Run(milliseconds(600));
  EXPECT_EQ(rig.shown.module, dbc::Module::kFlat);
  EXPECT_NEAR(rig.shown.heading_deg, 123.45, 0.005);
  EXPECT_NEAR(rig.shown.pitch_deg, -12.5, 1e-9);
  EXPECT_NEAR(rig.shown.roll_deg, 3.5, 1e-9);
  EXPECT_NEAR(rig.shown.speed_mps, -0.67, 0.0005);
  for (std::size_t j = 0; j < dbc::kJointCount; ++j) {
    // Steps of 0.01 deg; J7 of 0.1 mm.
    EXPECT_NEAR(rig.shown.joint[j], rig.robot.joint[j], j == 6 ? 5.1e-5 : 0.0051) << j;
  }
  EXPECT_EQ(rig.shown.grasp_state, 4);
  EXPECT_EQ(rig.lamp(Lamp::kGrasp), LampPattern::kSlowBlink);
  EXPECT_NEAR(rig.shown.battery_v, 25.61, 0.005);
  EXPECT_NEAR(rig.shown.battery_soc, 0.875, 0.0025);
  EXPECT_TRUE(rig.shown.is_simulator);
}

TEST(BridgeFeedback, HeadingNeverShows360) {
  for (const double heading : {359.996, 360.0, 720.0}) {
    BridgeRig rig;
    rig.robot.heading_deg = heading;
    rig.Run(milliseconds(60));
    EXPECT_EQ(rig.shown.heading_deg, 0.0) << heading;
  }
  BridgeRig negative;
  negative.robot.heading_deg = -90;
  negative.Run(milliseconds(60));
  EXPECT_NEAR(negative.shown.heading_deg, 270, 1e-9);
}

TEST(BridgeFeedback, MissionIsShownAndElapsedTimeSaturates) {
  BridgeRig rig;
  rig.Report(MissionReport{.state = 2,
                           .elapsed_s = 12.3,
                           .score = 87.5,
                           .step = 3,
                           .steps = 7,
                           .bomb_state = 1,
                           .fail_reason = 0,
                           .collisions = 300});
  rig.Run(milliseconds(260));
  EXPECT_EQ(rig.shown.mission_state, 2);
  EXPECT_NEAR(rig.shown.elapsed_s, 12.3, 0.05);
  EXPECT_NEAR(rig.shown.score, 87.5, 0.25);
  EXPECT_EQ(rig.shown.step, 3);
  EXPECT_EQ(rig.shown.steps, 7);
  EXPECT_EQ(rig.shown.bomb_state, 1);
  EXPECT_EQ(rig.shown.collisions, 255) << "eight bits";
  EXPECT_EQ(rig.lamp(Lamp::kMission), LampPattern::kOn);
  for (const int reason : {1, 2, 3, 4, 5, 6, 7, 8, 9}) {  // exploded .. wrong order
    rig.Report(MissionReport{.state = 4, .fail_reason = reason});
    rig.Run(milliseconds(260));
    EXPECT_EQ(rig.shown.mission_state, 4);
    EXPECT_EQ(rig.shown.fail_reason, reason);
  }
  rig.Report(MissionReport{.state = 2, .elapsed_s = 1e6});
  rig.Run(milliseconds(260));
  EXPECT_NEAR(rig.shown.elapsed_s, 6553.5, 1e-6) << "16 bits of 0.1 s";
}

TEST(BridgeFeedback, EndOfTheMissionSounds) {
  for (const int state : {3, 4}) {
    BridgeRig rig;
    rig.Report(MissionReport{.state = 2});
    rig.Run(milliseconds(100));
    rig.Report(MissionReport{.state = state});
    rig.Run(milliseconds(100));
    EXPECT_EQ(rig.shown.buzzer, state == 3 ? BuzzerPattern::kSuccess : BuzzerPattern::kFailure);
    rig.Run(milliseconds(2000));
    EXPECT_EQ(rig.shown.buzzer, BuzzerPattern::kOff);
  }
}

TEST(BridgeFeedback, LampsFollowTheState) {
  BridgeRig rig;
  rig.box_runs = false;
  rig.Run(milliseconds(60));
  EXPECT_EQ(rig.lamp(Lamp::kPower), LampPattern::kOn);
  EXPECT_EQ(rig.lamp(Lamp::kLink), LampPattern::kOff);
  rig.box_runs = true;
  rig.BringUp();
  EXPECT_EQ(rig.lamp(Lamp::kLink), LampPattern::kOn);
  EXPECT_EQ(rig.lamp(Lamp::kDeadman), LampPattern::kOn);
  EXPECT_EQ(rig.lamp(Lamp::kCamera), LampPattern::kOff);
  rig.panel_frames = true;
  rig.robot.grasp_state = 5;
  rig.panel.estop_a = false;
  rig.panel.estop_b = true;
  rig.Run(milliseconds(60));
  EXPECT_EQ(rig.lamp(Lamp::kCamera), LampPattern::kOn);
  EXPECT_EQ(rig.lamp(Lamp::kGrasp), LampPattern::kOn);
  EXPECT_EQ(rig.lamp(Lamp::kEstop), LampPattern::kOn);
  EXPECT_EQ(rig.shown.alarm_code, 0x80);
}

TEST(BridgeFeedback, HighestPriorityHasDisplayAndBuzzerAndEveryAlarmItsLamp) {
  BridgeRig rig;
  rig.Run(milliseconds(100));
  // Joint limit: priority 20, beep. Rollover: 80, continuous. Collision: 50, fast.
  rig.Alarm({{0x20, 1U << 8}, {0x31, 0}, {0x10, kFrontWheels}});
  rig.Run(milliseconds(10));
  EXPECT_EQ(rig.shown.alarm_code, 0x31);
  EXPECT_EQ(rig.shown.buzzer, BuzzerPattern::kContinuous);
  EXPECT_EQ(rig.lamp(Lamp::kLimit), LampPattern::kOn);
  EXPECT_EQ(rig.lamp(Lamp::kTilt), LampPattern::kFastBlink);
  EXPECT_EQ(rig.lamp(Lamp::kCollision), LampPattern::kFastBlink);
  EXPECT_EQ(rig.shown.hit_parts, kFrontWheels) << "what touches stays shown";
}

TEST(BridgeFeedback, AlarmThatTheMapDoesNotNameStaysOffTheBox) {
  BridgeRig rig;
  rig.Run(milliseconds(120));
  rig.Forget();
  rig.Alarm({{0x90, 0xFFF}});  // fault injected by the instructor
  EXPECT_TRUE(rig.sent.empty());
}

TEST(BridgeFeedback, AcknowledgeSilencesUntilTheNextNewAlarm) {
  BridgeRig rig;
  rig.panel_frames = true;
  rig.Run(milliseconds(100));
  rig.Alarm({{0x10, 0b01}});
  rig.panel.buzzer_acknowledge = true;
  rig.Run(milliseconds(60));
  EXPECT_EQ(rig.shown.buzzer, BuzzerPattern::kOff);
  EXPECT_EQ(rig.lamp(Lamp::kCollision), LampPattern::kFastBlink) << "the lamp stays";
  rig.panel.buzzer_acknowledge = false;
  rig.Alarm({{0x10, 0b11}});
  rig.Run(milliseconds(60));
  EXPECT_EQ(rig.shown.buzzer, BuzzerPattern::kOff) << "the same alarm, more parts";
  rig.Alarm({{0x10, 0b11}, {0x20, 0}});
  rig.Run(milliseconds(60));
  EXPECT_EQ(rig.shown.buzzer, BuzzerPattern::kFast) << "a new one";
}

TEST(BridgeFeedback, SilentSimulatorShowsFaultAndNoSpeed) {
  BridgeRig rig;
  rig.robot.speed_mps = 0.3;
  rig.BringUp();
  rig.simulator_runs = false;
  rig.Run(milliseconds(600));
  EXPECT_EQ(rig.shown.state, SystemState::kFault);
  EXPECT_EQ(rig.lamp(Lamp::kFault), LampPattern::kFastBlink);
  EXPECT_EQ(rig.shown.speed_mps, 0.0);
  rig.simulator_runs = true;
  rig.Run(milliseconds(60));
  EXPECT_EQ(rig.shown.state, SystemState::kOperate);
  EXPECT_EQ(rig.lamp(Lamp::kFault), LampPattern::kOff);
}

TEST(BridgeFeedback, FirstHeartbeatSaysBootUpAndTheOthersOperational) {
  BridgeRig rig;
  rig.Run(milliseconds(1));
  EXPECT_EQ(rig.SentAs(RobotMessage::kHeartbeat).size(), 1U);
  EXPECT_EQ(rig.sent[0].frame.id, 0x720U) << "before anything else";
  EXPECT_EQ(rig.sent[0].frame.data[0], 0x00);
  rig.Run(milliseconds(500));
  const std::vector<BridgeRig::Sent> beats = rig.SentAs(RobotMessage::kHeartbeat);
  ASSERT_GE(beats.size(), 3U);
  EXPECT_EQ(beats[1].frame.data[0], 0x05);
  EXPECT_EQ(beats[2].frame.data[0], 0x05);
}

TEST(BridgeFeedback, AgeOfTheLastBoxFrameIsToldAndSaturates) {
  BridgeRig rig;
  rig.BringUp();
  rig.Run(milliseconds(100));
  EXPECT_LE(rig.shown.box_frame_age_s, 0.02);
  rig.box_runs = false;
  rig.Run(milliseconds(3000));
  EXPECT_NEAR(rig.shown.box_frame_age_s, 1.27, 1e-9) << "7 bits of 10 ms";
}

TEST(BridgeFeedback, LinkQualityIsTheShareOfValidFramesInTheLastSecond) {
  BridgeRig rig;
  rig.BringUp();
  rig.Run(milliseconds(1200));
  EXPECT_GE(rig.shown.link_quality, 0.97);
  rig.box_runs = false;
  rig.Run(milliseconds(500));
  EXPECT_NEAR(rig.shown.link_quality, 0.5, 0.07);
  rig.Run(milliseconds(700));
  EXPECT_EQ(rig.shown.link_quality, 0.0);
}

TEST(BridgeFeedback, EmergencyMessageTellsTheFaultOnceAndItsEnd) {
  BridgeRig rig;
  rig.BringUp();
  EXPECT_TRUE(rig.SentAs(RobotMessage::kEmergency).empty());
  rig.panel.estop_a = false;
  rig.panel.estop_b = true;
  rig.Run(milliseconds(300));
  const std::vector<BridgeRig::Sent> frames = rig.SentAs(RobotMessage::kEmergency);
  ASSERT_EQ(frames.size(), 1U);
  // CiA 301: error code 0x9000 external error, little endian; register generic and manufacturer.
  EXPECT_EQ(FormatCandumpLine(frames[0].frame, "vcan0").substr(18), ") vcan0 0A0#0090810000000000");
}

}  // namespace
}  // namespace eod::bridge
