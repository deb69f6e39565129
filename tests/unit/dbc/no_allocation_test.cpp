#include <gtest/gtest.h>

#include "tests/unit/counting_new.h"
#include "tests/unit/dbc/samples.h"

namespace eod::dbc {
namespace {

class NoAllocation : public testing::TestWithParam<std::filesystem::path> {};
INSTANTIATE_TEST_SUITE_P(Boxes, NoAllocation, testing::Values(ShippedMapFile(), ShuffledMapFile()),
                         [](const auto& box) {
                           return std::string(box.index == 0 ? "shipped" : "shuffled");
                         });

TEST_P(NoAllocation, EncodingAndDecodingNeverAllocates) {
  Box box(GetParam());
  const PanelState panel = SampleState(PanelRoles(), 1);
  const RobotFeedback feedback = SampleState(FeedbackRoles(), 1);
  PanelState seen_panel;
  RobotFeedback seen_feedback;
  const long before = AllocationCount();
  EXPECT_GT(before, 0) << "the counter does not count";
  int accepted = 0;
  for (int round = 0; round < 20; ++round) {
    for (int i = 0; i < kBoxMessageCount; ++i) {
      CanFrame frame = *box.codec.Encode(static_cast<BoxMessage>(i), panel);
      accepted += box.codec.Decode(frame, seen_panel).verdict == FrameVerdict::kAccepted;
      frame.data[3] ^= 0x10;
      box.codec.Decode(frame, seen_panel);
    }
    for (int i = 0; i < kRobotMessageCount; ++i) {
      const CanFrame frame = *box.codec.Encode(static_cast<RobotMessage>(i), feedback);
      accepted += box.codec.Decode(frame, seen_feedback).verdict == FrameVerdict::kAccepted;
    }
    WantedRates(box.map, seen_panel);
  }
  const long after = AllocationCount();
  EXPECT_EQ(after - before, 0);
  EXPECT_EQ(accepted, 20 * (kBoxMessageCount + kRobotMessageCount));
}

}  // namespace
}  // namespace eod::dbc
