#include "dbc/box_codec.h"

#include <cmath>
#include <initializer_list>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dbc/e2e.h"
#include "dbc/signal_plan.h"
#include "tests/unit/dbc/samples.h"

namespace eod::dbc {
namespace {

using namespace std::chrono_literals;

std::vector<uint8_t> Bytes(const std::optional<CanFrame>& frame) {
  if (!frame) return {};
  return {frame->payload().begin(), frame->payload().end()};
}

/// Frame number `count` (from 0) of one message.
template <typename Role, typename State>
CanFrame NthFrame(BoxCodec& codec, Role role, const State& state, int count) {
  for (int i = 0; i < count; ++i) codec.Encode(role, state);
  return *codec.Encode(role, state);
}

CanFrame MakeFrame(uint32_t id, std::initializer_list<uint8_t> bytes) {
  CanFrame frame;
  frame.id = id;
  frame.length = static_cast<uint8_t>(bytes.size());
  std::copy(bytes.begin(), bytes.end(), frame.data.begin());
  return frame;
}

PanelState OperatingPanel() {
  PanelState panel;
  panel.key = KeySwitch::kOperate;
  panel.deadman = Deadman::kEnabled;
  return panel;
}

// ---- The example frames of the box's CAN description ----

class ShippedBox : public testing::Test {
 protected:
  Box box_{ShippedMapFile()};
};

TEST_F(ShippedBox, EncodesTheExampleSafetyFrames) {
  PanelState panel = OperatingPanel();
  EXPECT_EQ(Bytes(box_.codec.Encode(BoxMessage::kSafety, panel)),
            (std::vector<uint8_t>{0x98, 0x20, 0x05, 0x11, 0xC8, 0x00, 0x78, 0x10}));
  EXPECT_EQ(Bytes(box_.codec.Encode(BoxMessage::kSafety, panel)),
            (std::vector<uint8_t>{0xC5, 0x21, 0x05, 0x11, 0xC8, 0x00, 0x78, 0x10}));
  panel.estop_a = false;
  panel.estop_b = true;
  panel.deadman = Deadman::kReleased;
  const auto pressed = box_.codec.Encode(BoxMessage::kSafety, panel);
  EXPECT_EQ(pressed->id, 0x190u);
  EXPECT_EQ(Bytes(pressed), (std::vector<uint8_t>{0xED, 0x22, 0x02, 0x11, 0xC8, 0x00, 0x78, 0x10}));
}

TEST_F(ShippedBox, EncodesTheExampleMotionFrames) {
  PanelState panel;
  panel.joint_rate = 0;
  const CanFrame first = *box_.codec.Encode(BoxMessage::kMotion, panel);
  EXPECT_EQ(first.id, 0x290u);
  EXPECT_EQ(Bytes(first), (std::vector<uint8_t>{0x50, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(Bytes(NthFrame(box_.codec, BoxMessage::kMotion, panel, 13)),
            (std::vector<uint8_t>{0x51, 0x0E, 0, 0, 0, 0, 0, 0}));
  panel.joint_rate = 1;
  panel.motion[0] = true;
  EXPECT_EQ(Bytes(box_.codec.Encode(BoxMessage::kMotion, panel)),  // counter wraps to 0
            (std::vector<uint8_t>{0x6F, 0x00, 0x01, 0, 0, 0, 0xC8, 0}));
}

TEST_F(ShippedBox, EncodesTheExampleAxesFrame) {
  PanelState panel;
  panel.axis[0].value = 0.5;
  panel.axis[1].value = -0.25;
  const CanFrame frame = NthFrame(box_.codec, BoxMessage::kAxes, panel, 3);
  EXPECT_EQ(frame.id, 0x390u);
  EXPECT_EQ(Bytes(frame), (std::vector<uint8_t>{0xDB, 0x03, 0xF4, 0x61, 0xF0, 0, 0, 0}));
}

TEST_F(ShippedBox, EncodesTheExampleAlarmFrame) {
  RobotFeedback feedback;
  feedback.buzzer = BuzzerPattern::kFast;
  feedback.lamp[static_cast<size_t>(Lamp::kPower)] = LampPattern::kOn;
  feedback.lamp[static_cast<size_t>(Lamp::kLink)] = LampPattern::kOn;
  feedback.lamp[static_cast<size_t>(Lamp::kCollision)] = LampPattern::kFastBlink;
  feedback.hit_parts = 0b11;  // front left, front right
  feedback.alarm_code = 0x10;
  const CanFrame frame = NthFrame(box_.codec, RobotMessage::kAlarm, feedback, 5);
  EXPECT_EQ(frame.id, 0x2A0u);
  EXPECT_EQ(Bytes(frame), (std::vector<uint8_t>{0x88, 0x35, 0x05, 0x03, 0x00, 0x30, 0x00, 0x10}));
}

TEST_F(ShippedBox, DecodesTheExampleFrames) {
  PanelState panel;
  const auto safety =
      box_.codec.Decode(MakeFrame(0x190, {0xED, 0x22, 0x02, 0x11, 0xC8, 0x00, 0x78, 0x10}), panel);
  EXPECT_EQ(safety.verdict, FrameVerdict::kAccepted);
  EXPECT_EQ(safety.role, BoxMessage::kSafety);
  EXPECT_EQ(panel.key, KeySwitch::kOperate);
  EXPECT_FALSE(panel.estop_a);
  EXPECT_TRUE(panel.estop_b);
  EXPECT_EQ(panel.deadman, Deadman::kReleased);
  EXPECT_EQ(panel.mode, ControlMode::kDrive);
  EXPECT_EQ(panel.speed_range, SpeedRange::kLow);
  EXPECT_EQ(panel.speed_limit, 1);
  EXPECT_DOUBLE_EQ(panel.supply_v, 24);
  EXPECT_EQ(panel.protocol_major, 1);

  box_.codec.Decode(MakeFrame(0x390, {0xDB, 0x03, 0xF4, 0x61, 0xF0, 0, 0, 0}), panel);
  EXPECT_DOUBLE_EQ(panel.axis[0].value, 0.5);
  EXPECT_DOUBLE_EQ(panel.axis[1].value, -0.25);

  RobotFeedback feedback;
  box_.codec.Decode(MakeFrame(0x2A0, {0x88, 0x35, 0x05, 0x03, 0x00, 0x30, 0x00, 0x10}), feedback);
  EXPECT_EQ(feedback.buzzer, BuzzerPattern::kFast);
  EXPECT_EQ(feedback.lamp[static_cast<size_t>(Lamp::kCollision)], LampPattern::kFastBlink);
  EXPECT_EQ(feedback.hit_parts, 0b11u);
  EXPECT_EQ(feedback.alarm_code, 0x10);
}

// ---- Verdicts ----

TEST_F(ShippedBox, JudgesFrames) {
  PanelState panel;
  const CanFrame good = *box_.codec.Encode(BoxMessage::kSafety, OperatingPanel());
  const auto verdict = [&](const CanFrame& frame) {
    return box_.codec.Decode(frame, panel).verdict;
  };
  EXPECT_EQ(verdict(good), FrameVerdict::kAccepted);
  EXPECT_EQ(verdict(good), FrameVerdict::kRepeated);

  CanFrame damaged = *box_.codec.Encode(BoxMessage::kSafety, OperatingPanel());
  damaged.data[3] ^= 1;
  EXPECT_EQ(verdict(damaged), FrameVerdict::kWrongCrc);
  CanFrame cut = good;
  cut.length = 7;
  EXPECT_EQ(verdict(cut), FrameVerdict::kWrongLength);
  CanFrame extended = good;
  extended.extended = true;
  EXPECT_EQ(verdict(extended), FrameVerdict::kUnknownId);
  EXPECT_FALSE(box_.codec.Decode(extended, panel).role);
  CanFrame remote = good;
  remote.remote = true;
  EXPECT_EQ(verdict(remote), FrameVerdict::kUnknownId);
  CanFrame error = good;
  error.error = true;
  EXPECT_EQ(verdict(error), FrameVerdict::kUnknownId);
  CanFrame fire_id = good;  // a message that the robot sends does not concern the robot's end
  fire_id.id = 0x1A0;
  EXPECT_EQ(verdict(fire_id), FrameVerdict::kUnknownId);
}

TEST_F(ShippedBox, DroppedFramesChangeNothing) {
  PanelState panel;
  box_.codec.Decode(*box_.codec.Encode(BoxMessage::kSafety, OperatingPanel()), panel);
  const PanelState before = panel;
  CanFrame damaged = *box_.codec.Encode(BoxMessage::kSafety, PanelState{});
  damaged.data[0] ^= 0xFF;
  box_.codec.Decode(damaged, panel);
  EXPECT_EQ(panel, before);
}

TEST_F(ShippedBox, ResynchronisesAfterAJump) {
  PanelState panel;
  const auto verdict = [&](int skip) {
    return box_.codec.Decode(NthFrame(box_.codec, BoxMessage::kMotion, PanelState{}, skip), panel)
        .verdict;
  };
  EXPECT_EQ(verdict(0), FrameVerdict::kAccepted);
  EXPECT_EQ(verdict(2), FrameVerdict::kAccepted);       // 2 lost
  EXPECT_EQ(verdict(3), FrameVerdict::kWrongSequence);  // 3 lost: too many
  EXPECT_EQ(verdict(0), FrameVerdict::kWrongSequence);
  EXPECT_EQ(verdict(0), FrameVerdict::kWrongSequence);
  EXPECT_EQ(verdict(0), FrameVerdict::kAccepted);  // the third good one
  EXPECT_EQ(box_.codec.lost(), 5u);
  EXPECT_EQ(verdict(7), FrameVerdict::kWrongSequence);
  box_.codec.ResetSequences();
  EXPECT_EQ(verdict(7), FrameVerdict::kAccepted);
}

TEST_F(ShippedBox, KnowsTimesAndIdentifiers) {
  EXPECT_EQ(box_.codec.cycle_time(BoxMessage::kSafety), 20ms);
  EXPECT_EQ(box_.codec.cycle_time(BoxMessage::kEmergency), 0ms);
  EXPECT_EQ(box_.codec.cycle_time(RobotMessage::kAlarm), 50ms);
  EXPECT_EQ(box_.codec.cycle_time(RobotMessage::kBattery), 500ms);
  EXPECT_TRUE(box_.codec.IsRobotId(0x1A0, false));
  EXPECT_FALSE(box_.codec.IsRobotId(0x1A0, true));
  EXPECT_FALSE(box_.codec.IsRobotId(0x190, false));
  EXPECT_TRUE(box_.codec.IsBoxId(0x190, false));
  EXPECT_FALSE(box_.codec.IsBoxId(0x1A0, false));
}

// ---- Safe values ----

class RawFrame : public ShippedBox {
 protected:
  /// The panel after a frame of `message` whose `signal` holds `raw`, CRC made good.
  PanelState PanelWith(BoxMessage role, const std::string& message, const std::string& signal,
                       int64_t raw) {
    PanelState panel;
    CanFrame frame = *box_.codec.Encode(role, OperatingPanel());
    const Message& bits = *box_.database.FindMessage(message);
    const SignalPlan plan(*bits.FindSignal(signal), bits.length);
    plan.EncodeRaw(raw, frame.data);
    if (const auto id = bits.e2e_data_id())
      frame.data[0] = E2eCrc(*id, std::span(frame.data).first(8), 0);
    EXPECT_EQ(box_.codec.Decode(frame, panel).verdict, FrameVerdict::kAccepted);
    return panel;
  }
};

TEST_F(RawFrame, UnknownChoicesDecodeToTheSafeValue) {
  EXPECT_EQ(PanelWith(BoxMessage::kSafety, "BOX_SAFETY", "KeySwitch", 5).key,
            KeySwitch::kNotAvailable);
  EXPECT_EQ(PanelWith(BoxMessage::kSafety, "BOX_SAFETY", "ControlMode", 9).mode,
            ControlMode::kNotAvailable);
  EXPECT_EQ(PanelWith(BoxMessage::kFire, "BOX_FIRE", "FireLeft", 3).fire_left, FireContact::kFault);
  EXPECT_EQ(PanelWith(BoxMessage::kFire, "BOX_FIRE", "FireLeft", 0).fire_left, FireContact::kFault);
  EXPECT_EQ(PanelWith(BoxMessage::kHeartbeat, "BOX_HEARTBEAT", "NmtState", 17).nmt,
            NmtState::kUnknown);
  EXPECT_EQ(PanelWith(BoxMessage::kPanel, "BOX_PANEL", "MenuModule", 6).menu_module,
            Module::kNotAvailable);
  EXPECT_EQ(PanelWith(BoxMessage::kMotion, "BOX_MOTION", "PresetReq", 15).preset, 0);
}

TEST_F(RawFrame, AxesSayErrorAndNotAvailable) {
  for (const int64_t raw : {-2048, -2047, 1001, 2047, -1001}) {  // range is +-1000
    const Axis axis = PanelWith(BoxMessage::kAxes, "BOX_AXES", "AxisDriveX", raw).axis[1];
    EXPECT_FALSE(axis.valid) << raw;
    EXPECT_EQ(axis.value, 0) << raw;
  }
  EXPECT_EQ(PanelWith(BoxMessage::kAxes, "BOX_AXES", "AxisDriveX", -1000).axis[1],
            (Axis{-1, true}));
}

TEST_F(RawFrame, ValuesBeyondTheDeclaredRangeAreNone) {
  EXPECT_EQ(PanelWith(BoxMessage::kSafety, "BOX_SAFETY", "SpeedLimit", 201).speed_limit, 0);
  EXPECT_EQ(PanelWith(BoxMessage::kSafety, "BOX_SAFETY", "SpeedLimit", 200).speed_limit, 1);
  EXPECT_EQ(PanelWith(BoxMessage::kMotion, "BOX_MOTION", "JointRate", 255).joint_rate, 0);
}

TEST_F(ShippedBox, EncodesWhatIsNoNumberAsSafe) {
  PanelState panel;
  panel.speed_limit = std::nan("");
  panel.supply_v = HUGE_VAL;
  panel.axis[0] = {std::nan(""), true};
  panel.axis[1] = {0.7, false};
  panel.axis[2] = {-HUGE_VAL, true};
  PanelState seen;
  box_.codec.Decode(*box_.codec.Encode(BoxMessage::kSafety, panel), seen);
  box_.codec.Decode(*box_.codec.Encode(BoxMessage::kAxes, panel), seen);
  EXPECT_EQ(seen.speed_limit, 0);
  EXPECT_DOUBLE_EQ(seen.supply_v, 50);  // the end of the range
  EXPECT_FALSE(seen.axis[0].valid);
  EXPECT_FALSE(seen.axis[1].valid);
  EXPECT_EQ(seen.axis[2], (Axis{-1, true}));
}

TEST_F(ShippedBox, NoBitsDecodeToNanOrInfinity) {
  Dice dice(7);
  for (int round = 0; round < 20'000; ++round) {
    CanFrame frame;
    frame.id = box_.database.messages[dice.Bits() % box_.database.messages.size()].id;
    frame.length = 8;
    for (size_t i = 0; i < 8; ++i) frame.data[i] = static_cast<uint8_t>(dice.Bits());
    if (const auto id = box_.database.FindMessage(frame.id, false)->e2e_data_id()) {
      frame.data[0] = E2eCrc(*id, frame.payload(), 0);
    }
    box_.codec.ResetSequences();
    PanelState panel;
    RobotFeedback feedback;
    box_.codec.Decode(frame, panel);
    box_.codec.Decode(frame, feedback);
    for (const auto& role : PanelRoles()) {
      if (role.kind == RoleKind::kAxis) continue;
      ASSERT_TRUE(std::isfinite(role.get(panel, role.index))) << role.name;
    }
    for (const Axis& axis : panel.axis) ASSERT_LE(std::abs(axis.value), 1);
    for (const auto& role : FeedbackRoles()) {
      ASSERT_TRUE(std::isfinite(role.get(feedback, role.index))) << role.name;
    }
  }
}

}  // namespace
}  // namespace eod::dbc
