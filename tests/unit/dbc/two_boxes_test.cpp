// Two boxes that share nothing but their meaning: the shipped one, and one with other identifiers,
// places, byte order, scales, units, labels and cycle times. Both are only files.

#include <gtest/gtest.h>

#include "tests/unit/dbc/samples.h"

namespace eod::dbc {
namespace {

/// `state` after its way over the bus, all messages of its direction.
template <typename MessageRole, typename State>
State OverTheBus(BoxCodec& sender, BoxCodec& receiver, const State& state, int message_count) {
  State received;
  for (int i = 0; i < message_count; ++i) {
    const auto role = static_cast<MessageRole>(i);
    const auto frame = sender.Encode(role, state);
    EXPECT_TRUE(frame);
    const auto result = receiver.Decode(*frame, received);
    EXPECT_EQ(result.verdict, FrameVerdict::kAccepted) << i;
    EXPECT_EQ(result.role, role);
  }
  return received;
}

PanelState PanelOverTheBus(BoxCodec& sender, BoxCodec& receiver, const PanelState& panel) {
  return OverTheBus<BoxMessage>(sender, receiver, panel, kBoxMessageCount);
}
RobotFeedback FeedbackOverTheBus(BoxCodec& sender, BoxCodec& receiver,
                                 const RobotFeedback& feedback) {
  return OverTheBus<RobotMessage>(sender, receiver, feedback, kRobotMessageCount);
}

class BothBoxes : public testing::TestWithParam<const char*> {
 protected:
  static std::filesystem::path MapFile() {
    return std::string_view(GetParam()) == "shipped" ? ShippedMapFile() : ShuffledMapFile();
  }
  Box sender_{MapFile()};
  Box receiver_{MapFile()};
};
INSTANTIATE_TEST_SUITE_P(Boxes, BothBoxes, testing::Values("shipped", "shuffled"),
                         [](const auto& box) { return std::string(box.param); });

TEST_P(BothBoxes, CarryEveryFieldOfThePanel) {
  for (uint64_t seed = 0; seed < 500; ++seed) {
    const PanelState panel = SampleState(PanelRoles(), seed);
    ExpectSameFields(PanelRoles(), PanelOverTheBus(sender_.codec, receiver_.codec, panel), panel);
    if (HasFailure()) FAIL() << "seed " << seed;
  }
}

TEST_P(BothBoxes, CarryEveryFieldOfTheFeedback) {
  for (uint64_t seed = 0; seed < 500; ++seed) {
    const RobotFeedback feedback = SampleState(FeedbackRoles(), seed);
    ExpectSameFields(FeedbackRoles(), FeedbackOverTheBus(sender_.codec, receiver_.codec, feedback),
                     feedback);
    if (HasFailure()) FAIL() << "seed " << seed;
  }
}

TEST_P(BothBoxes, CarryEachFieldByItself) {
  // Every field changed alone: no two fields share bits, none is forgotten.
  Dice dice(3);
  for (const auto& role : PanelRoles()) {
    PanelState panel;
    role.set(panel, role.index, SampleValue(role, dice));
    ExpectSameFields(PanelRoles(), PanelOverTheBus(sender_.codec, receiver_.codec, panel), panel);
  }
  for (const auto& role : FeedbackRoles()) {
    RobotFeedback feedback;
    role.set(feedback, role.index, SampleValue(role, dice));
    ExpectSameFields(FeedbackRoles(), FeedbackOverTheBus(sender_.codec, receiver_.codec, feedback),
                     feedback);
  }
}

TEST(TwoBoxes, MeanTheSameThingInOtherBits) {
  Box shipped(ShippedMapFile());
  Box shuffled(ShuffledMapFile());
  for (uint64_t seed = 0; seed < 100; ++seed) {
    const PanelState panel = SampleState(PanelRoles(), seed);
    ExpectSameFields(PanelRoles(), PanelOverTheBus(shipped.codec, shipped.codec, panel),
                     PanelOverTheBus(shuffled.codec, shuffled.codec, panel));
    const RobotFeedback feedback = SampleState(FeedbackRoles(), seed);
    ExpectSameFields(FeedbackRoles(), FeedbackOverTheBus(shipped.codec, shipped.codec, feedback),
                     FeedbackOverTheBus(shuffled.codec, shuffled.codec, feedback));
  }
}

TEST(TwoBoxes, ShareNoIdentifierAndNoCycleTime) {
  Box shipped(ShippedMapFile());
  Box shuffled(ShuffledMapFile());
  for (int i = 0; i < kBoxMessageCount; ++i) {
    const auto role = static_cast<BoxMessage>(i);
    const CanFrame frame = *shuffled.codec.Encode(role, PanelState{});
    PanelState panel;
    EXPECT_EQ(shipped.codec.Decode(frame, panel).verdict, FrameVerdict::kUnknownId);
    EXPECT_FALSE(shipped.codec.IsBoxId(frame.id, frame.extended));
    EXPECT_TRUE(shuffled.codec.IsBoxId(frame.id, frame.extended));
    EXPECT_EQ(shuffled.codec.cycle_time(role), 2 * shipped.codec.cycle_time(role));
  }
}

TEST(TwoBoxes, UseClassicFdStandardAndExtendedFrames) {
  Box shuffled(ShuffledMapFile());
  bool is_fd = false;
  bool is_classic = false;
  bool is_extended = false;
  bool is_standard = false;
  for (int i = 0; i < kRobotMessageCount; ++i) {
    const CanFrame frame = *shuffled.codec.Encode(static_cast<RobotMessage>(i), RobotFeedback{});
    (frame.fd ? is_fd : is_classic) = true;
    (frame.extended ? is_extended : is_standard) = true;
    EXPECT_EQ(frame.fd, frame.length > 8);
  }
  EXPECT_TRUE(is_fd && is_classic && is_extended && is_standard);
}

}  // namespace
}  // namespace eod::dbc
