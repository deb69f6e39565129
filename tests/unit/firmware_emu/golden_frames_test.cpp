// The example frames of the CAN specification, made by the box from the named panel states.
#include <algorithm>
#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/firmware_emu/box_rig.h"

namespace eod::box {
namespace {

using Bytes = std::array<uint8_t, 8>;

Bytes BytesOf(const CanFrame& frame) {
  Bytes bytes{};
  std::copy_n(frame.data.begin(), 8, bytes.begin());
  return bytes;
}

// A box that has just become operational with `inputs` set, and what it sent first with `id`: its
// counters begin at 0 there.
std::vector<Bytes> FirstFrames(const std::function<void(BoxRig&)>& operate, uint32_t id) {
  BoxRig rig;
  rig.PowerUp();
  // Power off and on again would keep the counters; so the controls change before the 15 frames of
  // one counter round are over, and the frames are picked by their counter in the next round.
  operate(rig);
  rig.Run(milliseconds(20));
  rig.sent.clear();
  rig.Run(milliseconds(20 * 30));
  std::vector<Bytes> by_counter(15);
  for (const CanFrame& frame : rig.SentWithId(id))
    by_counter[frame.data[1] & 0x0F] = BytesOf(frame);
  return by_counter;
}

TEST(GoldenFrame, SafetyInOperateAndEnabled) {
  const auto frames = FirstFrames(
      [](BoxRig& rig) {
        rig.inputs.controls.key = dbc::KeySwitch::kOperate;
        rig.inputs.controls.deadman = dbc::Deadman::kEnabled;
      },
      kSafetyId);
  EXPECT_EQ(frames[0], (Bytes{0x98, 0x20, 0x05, 0x11, 0xC8, 0x00, 0x78, 0x10}));
  EXPECT_EQ(frames[1], (Bytes{0xC5, 0x21, 0x05, 0x11, 0xC8, 0x00, 0x78, 0x10}));
}

TEST(GoldenFrame, SafetyWithEstopPressedAndDeadmanReleased) {
  const auto frames = FirstFrames(
      [](BoxRig& rig) {
        rig.inputs.controls.key = dbc::KeySwitch::kOperate;
        rig.inputs.estop_pressed = true;
      },
      kSafetyId);
  EXPECT_EQ(frames[2], (Bytes{0xED, 0x22, 0x02, 0x11, 0xC8, 0x00, 0x78, 0x10}));
}

TEST(GoldenFrame, MotionForward) {
  const auto frames =
      FirstFrames([](BoxRig& rig) { rig.inputs.controls.motion[0] = true; }, kMotionId);
  EXPECT_EQ(frames[0], (Bytes{0x6F, 0x00, 0x01, 0x00, 0x00, 0x00, 0xC8, 0x00}));
}

TEST(GoldenFrame, MotionAllZero) {
  const auto frames =
      FirstFrames([](BoxRig& rig) { rig.inputs.controls.joint_rate = 0; }, kMotionId);
  EXPECT_EQ(frames[0], (Bytes{0x50, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00}));
  EXPECT_EQ(frames[14], (Bytes{0x51, 0x0E, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00}));
}

TEST(GoldenFrame, AxesHalfForwardQuarterLeft) {
  const auto frames = FirstFrames(
      [](BoxRig& rig) {
        rig.inputs.controls.axis[0].value = 0.50;
        rig.inputs.controls.axis[1].value = -0.25;
      },
      kAxesId);
  EXPECT_EQ(frames[3], (Bytes{0xDB, 0x03, 0xF4, 0x61, 0xF0, 0x00, 0x00, 0x00}));
}

TEST(GoldenFrame, AlarmShowsOnTheBox) {
  BoxRig rig;
  rig.PowerUp();
  CanFrame frame;
  frame.id = 0x2A0;
  frame.length = 8;
  const Bytes bytes{0x88, 0x35, 0x05, 0x03, 0x00, 0x30, 0x00, 0x10};
  std::copy(bytes.begin(), bytes.end(), frame.data.begin());
  rig.dut.OnFrame(frame, rig.now);
  rig.Run(milliseconds(1));
  const PanelStatus& shown = rig.dut.status();
  EXPECT_EQ(shown.buzzer, dbc::BuzzerPattern::kFast);
  EXPECT_EQ(shown.lamp[static_cast<size_t>(dbc::Lamp::kPower)], dbc::LampPattern::kOn);
  EXPECT_EQ(shown.lamp[static_cast<size_t>(dbc::Lamp::kLink)], dbc::LampPattern::kOn);
  EXPECT_EQ(shown.lamp[static_cast<size_t>(dbc::Lamp::kCollision)], dbc::LampPattern::kFastBlink);
  EXPECT_EQ(shown.feedback.hit_parts, 0x3u);  // front left and front right wheel
  EXPECT_EQ(shown.feedback.alarm_code, 0x10);
}

}  // namespace
}  // namespace eod::box
