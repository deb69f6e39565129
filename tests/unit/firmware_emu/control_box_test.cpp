// States, faults, link and display of the control box.
#include <algorithm>

#include <gtest/gtest.h>

#include "tests/unit/firmware_emu/box_rig.h"

namespace eod::box {
namespace {

using dbc::Deadman;
using dbc::KeySwitch;
using dbc::Lamp;
using dbc::LampPattern;
using dbc::SystemState;

LampPattern Shown(const BoxRig& rig, Lamp lamp) {
  return rig.dut.status().lamp[static_cast<size_t>(lamp)];
}

/// A box with the key in Operate and a robot that answers.
BoxRig OperatingBox() {
  BoxRig rig;
  rig.robot_talks = true;
  rig.PowerUp();
  rig.inputs.controls.key = KeySwitch::kOperate;
  rig.robot.state = SystemState::kOperate;
  rig.Run(milliseconds(100));
  return rig;
}

TEST(BoxState, PowerUpGoesThroughBootAndSelfTestToStandby) {
  BoxRig rig;
  rig.Tick();
  EXPECT_EQ(rig.dut.status().state, BoxState::kBoot);
  rig.Run(milliseconds(99));
  EXPECT_EQ(rig.dut.status().state, BoxState::kBoot);
  EXPECT_TRUE(rig.sent.empty());
  rig.Run(milliseconds(1));
  EXPECT_EQ(rig.dut.status().state, BoxState::kSelfTest);
  rig.Run(milliseconds(399));
  EXPECT_EQ(rig.dut.status().state, BoxState::kSelfTest);
  rig.Run(milliseconds(1));
  EXPECT_EQ(rig.dut.status().state, BoxState::kStandby);
}

TEST(BoxState, SelfTestLightsAllLamps) {
  BoxRig rig;
  rig.Tick();
  rig.Run(milliseconds(200));
  for (const bool lit : rig.dut.status().lit) EXPECT_TRUE(lit);
  rig.Run(milliseconds(400));
  EXPECT_FALSE(rig.dut.status().lit[static_cast<size_t>(Lamp::kCollision)]);
}

TEST(BoxState, KeyGivesReadyAndTheRobotGivesOperate) {
  BoxRig rig;
  rig.robot_talks = true;
  rig.robot.state = SystemState::kReady;
  rig.PowerUp();
  rig.inputs.controls.key = KeySwitch::kOperate;
  rig.Run(milliseconds(50));
  EXPECT_EQ(rig.dut.status().state, BoxState::kReady);
  rig.robot.state = SystemState::kOperate;
  rig.Run(milliseconds(50));
  EXPECT_EQ(rig.dut.status().state, BoxState::kOperate);
  rig.inputs.controls.key = KeySwitch::kStandby;
  rig.Run(milliseconds(50));
  EXPECT_EQ(rig.dut.status().state, BoxState::kStandby);
}

TEST(BoxState, EstopStaysLatchedUntilReleasedAndReset) {
  BoxRig rig = OperatingBox();
  rig.inputs.estop_pressed = true;
  rig.Run(milliseconds(1));
  EXPECT_EQ(rig.dut.status().state, BoxState::kEstopLatched);
  // Reset while it is pressed does nothing.
  rig.inputs.controls.reset = dbc::Button::kPressed;
  rig.Run(milliseconds(50));
  rig.inputs.controls.reset = dbc::Button::kReleased;
  rig.inputs.estop_pressed = false;
  rig.Run(milliseconds(200));
  EXPECT_EQ(rig.dut.status().state, BoxState::kEstopLatched);
  rig.inputs.controls.reset = dbc::Button::kPressed;
  rig.Run(milliseconds(50));
  EXPECT_EQ(rig.dut.status().state, BoxState::kOperate);
}

TEST(BoxState, RobotsOwnEstopShowsAsLatched) {
  BoxRig rig = OperatingBox();
  rig.robot.state = SystemState::kEstopLatched;
  rig.Run(milliseconds(50));
  EXPECT_EQ(rig.dut.status().state, BoxState::kEstopLatched);
}

TEST(BoxState, PowerLossSilencesAndDarkensTheBoxAndPowerBootsItAgain) {
  BoxRig rig = OperatingBox();
  rig.inputs.powered = false;
  rig.Run(milliseconds(1));
  rig.sent.clear();
  rig.Run(milliseconds(500));
  EXPECT_EQ(rig.dut.status().state, BoxState::kOff);
  EXPECT_TRUE(rig.sent.empty());
  for (const bool lit : rig.dut.status().lit) EXPECT_FALSE(lit);
  rig.inputs.powered = true;
  rig.Run(milliseconds(101));
  ASSERT_EQ(rig.sent.size(), 1u);
  EXPECT_EQ(rig.sent[0].id, kHeartbeatId);
  EXPECT_EQ(rig.sent[0].data[0], 0);  // boot-up
}

TEST(Link, IsLostAfter500MillisecondsOfSilenceAndBackWithTheFirstFrame) {
  BoxRig rig = OperatingBox();  // now = 620, the last robot frames came at 600
  rig.robot_talks = false;
  rig.Run(milliseconds(480));
  EXPECT_EQ(rig.dut.status().state, BoxState::kOperate);
  rig.Run(milliseconds(1));
  EXPECT_EQ(rig.dut.status().state, BoxState::kLinkLost);
  EXPECT_FALSE(rig.dut.status().link_up);
  rig.robot_talks = true;
  rig.Run(milliseconds(50));
  EXPECT_TRUE(rig.dut.status().link_up);
  EXPECT_EQ(rig.dut.status().state, BoxState::kOperate);
}

TEST(Link, ARobotThatNeverCameIsLostToo) {
  BoxRig rig;
  rig.PowerUp();
  EXPECT_EQ(rig.dut.status().state, BoxState::kStandby);
  rig.Run(milliseconds(500));
  EXPECT_EQ(rig.dut.status().state, BoxState::kLinkLost);
}

TEST(Link, LostLinkShowsLocalLampsOnly) {
  BoxRig rig;
  rig.robot_talks = true;
  rig.robot.lamp[static_cast<size_t>(Lamp::kCollision)] = LampPattern::kFastBlink;
  rig.PowerUp();
  rig.Run(milliseconds(50));
  EXPECT_EQ(Shown(rig, Lamp::kCollision), LampPattern::kFastBlink);
  rig.robot_talks = false;
  rig.Run(milliseconds(600));
  EXPECT_EQ(Shown(rig, Lamp::kCollision), LampPattern::kOff);
  EXPECT_EQ(Shown(rig, Lamp::kLink), LampPattern::kFastBlink);
  EXPECT_EQ(Shown(rig, Lamp::kPower), LampPattern::kOn);
  EXPECT_EQ(rig.dut.status().buzzer, dbc::BuzzerPattern::kSlow);
}

TEST(Link, FramesWithAWrongCrcDoNotKeepItUpAndAreCounted) {
  BoxRig rig = OperatingBox();
  rig.robot_talks = false;
  CanFrame broken = *rig.robot_codec.Encode(dbc::RobotMessage::kStatus, rig.robot);
  broken.data[7] ^= 0x01;
  for (int i = 0; i < 60; ++i) {
    rig.Run(milliseconds(10));
    rig.dut.OnFrame(broken, rig.now);
  }
  EXPECT_EQ(rig.dut.status().crc_errors, 60u);
  EXPECT_EQ(rig.dut.status().state, BoxState::kLinkLost);
}

TEST(Link, RepeatedShortAndForeignFramesAreCounted) {
  BoxRig rig = OperatingBox();
  rig.robot_talks = false;
  const CanFrame good = *rig.robot_codec.Encode(dbc::RobotMessage::kStatus, rig.robot);
  rig.dut.OnFrame(good, rig.now);
  const uint64_t accepted = rig.dut.status().rx;
  rig.dut.OnFrame(good, rig.now);
  CanFrame shorter = good;
  shorter.length = 7;
  rig.dut.OnFrame(shorter, rig.now);
  CanFrame foreign = good;
  foreign.id = 0x123;
  rig.dut.OnFrame(foreign, rig.now);
  EXPECT_EQ(rig.dut.status().sequence_errors, 1u);
  EXPECT_EQ(rig.dut.status().length_errors, 1u);
  EXPECT_EQ(rig.dut.status().foreign_frames, 1u);
  EXPECT_EQ(rig.dut.status().rx, accepted);
}

TEST(Display, LampTestLightsEverythingAndChangesNoPattern) {
  BoxRig rig = OperatingBox();
  rig.inputs.controls.lamp_test = true;
  rig.Run(milliseconds(1));
  for (const bool lit : rig.dut.status().lit) EXPECT_TRUE(lit);
  EXPECT_EQ(Shown(rig, Lamp::kFault), LampPattern::kOff);
  rig.Run(milliseconds(50));
  EXPECT_EQ(rig.SentWithId(kPanelId).back().data[3] & 0x02, 0x02);  // LampTest, bit 25
}

TEST(Display, BuzzerBeginsItsPatternWhenItIsTold) {
  BoxRig rig = OperatingBox();
  rig.robot.buzzer = dbc::BuzzerPattern::kBeep;
  rig.Run(milliseconds(40));  // now = 660, told at 650
  EXPECT_TRUE(rig.dut.status().is_sounding);
  rig.Run(milliseconds(200));
  EXPECT_FALSE(rig.dut.status().is_sounding);
}

TEST(Fault, ButtonHeldAtPowerUpIsAFaultUntilLetGo) {
  BoxRig rig;
  rig.robot_talks = true;
  rig.inputs.controls.motion[0] = true;
  rig.PowerUp();
  EXPECT_EQ(rig.dut.status().state, BoxState::kFault);
  EXPECT_EQ(rig.dut.status().fault, BoxFault::kStuckControl);
  rig.Run(milliseconds(100));
  EXPECT_EQ(rig.SentWithId(kSafetyId).back().data[5], 1);           // BoxFault
  EXPECT_EQ(rig.SentWithId(kMotionId).back().data[2] & 1, 0);       // ignored
  EXPECT_EQ(rig.SentWithId(kMotionId).back().data[4] >> 6 & 1, 1);  // BtnChannelFault, bit 38
  rig.inputs.controls.motion[0] = false;
  rig.Run(milliseconds(20));
  EXPECT_EQ(rig.dut.status().state, BoxState::kStandby);
  const auto emergencies = rig.SentWithId(kEmergencyId);
  ASSERT_EQ(emergencies.size(), 2u);        // came, went
  EXPECT_EQ(emergencies[0].data[0], 0x01);  // 0xFF01, low byte first: maker's own code, fault 1
  EXPECT_EQ(emergencies[0].data[1], 0xFF);
  EXPECT_EQ(emergencies[0].data[2], 0x81);  // register: generic, maker's own
  EXPECT_EQ(emergencies[1].data[0], 0x00);  // error reset
  EXPECT_EQ(emergencies[1].data[1], 0x00);
}

TEST(Fault, BrokenEstopContactIsPressedAtOnceAndAFaultAfter60Milliseconds) {
  BoxRig rig = OperatingBox();
  rig.inputs.estop_a_fault = true;
  rig.Run(milliseconds(1));
  EXPECT_EQ(rig.dut.status().state, BoxState::kEstopLatched);
  EXPECT_EQ(rig.SentWithId(kSafetyId).back().data[2] & 0x03, 0x00);  // A = B = 0
  rig.Run(milliseconds(60));
  EXPECT_EQ(rig.dut.status().fault, BoxFault::kEstopChannels);
  EXPECT_EQ(rig.SentWithId(kEmergencyId).size(), 1u);
}

TEST(Fault, StickWithoutAValueIsTold) {
  BoxRig rig = OperatingBox();
  rig.inputs.controls.axis[0].valid = false;
  rig.Run(milliseconds(30));
  EXPECT_EQ(rig.dut.status().state, BoxState::kFault);
  EXPECT_EQ(rig.dut.status().fault, BoxFault::kAxis);
}

TEST(Display, PoseTimeIsThatOfTheLastPoseFrameAlone) {
  BoxRig rig = OperatingBox();
  rig.robot_talks = false;
  rig.dut.OnFrame(*rig.robot_codec.Encode(dbc::RobotMessage::kPose, rig.robot), rig.now);
  const TimePoint pose = rig.now;
  rig.Run(milliseconds(20));
  rig.dut.OnFrame(*rig.robot_codec.Encode(dbc::RobotMessage::kStatus, rig.robot), rig.now);
  EXPECT_EQ(rig.dut.status().pose_time, pose);
  CanFrame wrong = *rig.robot_codec.Encode(dbc::RobotMessage::kPose, rig.robot);
  wrong.data[0] ^= 1;
  rig.dut.OnFrame(wrong, rig.now);
  EXPECT_EQ(rig.dut.status().pose_time, pose) << "a frame that is dropped shows nothing";
}

TEST(Fire, NonceOfTheRobotIsEchoed) {
  BoxRig rig = OperatingBox();
  rig.robot.nonce = 0xA5;
  rig.Run(milliseconds(100));
  EXPECT_EQ(rig.SentWithId(kFireId).back().data[3], 0xA5);
}

}  // namespace
}  // namespace eod::box
