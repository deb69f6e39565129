#include "platform/recording_can_bus.h"

#include <gtest/gtest.h>

#include "platform/inproc_can_bus.h"

namespace eod {
namespace {

class RecordingCanBusTest : public testing::Test {
 protected:
  ManualClock clock_{TimePoint{std::chrono::seconds{10}}};
  InprocCanHub hub_;
  std::unique_ptr<CanBus> peer_ = hub_.Connect(clock_);
  std::string file_ = testing::TempDir() + "recording_can_bus_test.log";
  std::unique_ptr<CanBus> dut_ =
      std::make_unique<RecordingCanBus>(hub_.Connect(clock_), CandumpWriter(file_, "hub"), clock_);
};

TEST_F(RecordingCanBusTest, WritesSentAndReceivedFramesInTheOrderSeen) {
  dut_->Send({.id = 1});
  clock_.Advance(std::chrono::milliseconds{1});
  peer_->Send({.id = 2});
  clock_.Advance(std::chrono::milliseconds{1});
  EXPECT_EQ(dut_->Receive()->id, 2U);
  EXPECT_FALSE(dut_->Receive().has_value());
  dut_->Send({.id = 3});
  dut_.reset();

  const auto log = ReadCandumpLog(file_);
  ASSERT_EQ(log.size(), 3U);
  EXPECT_EQ(log[0].id, 1U);
  EXPECT_EQ(ToUtime(log[0].stamp), 10'000'000);
  EXPECT_EQ(log[1].id, 2U);
  EXPECT_EQ(ToUtime(log[1].stamp), 10'001'000) << "the moment on the bus";
  EXPECT_EQ(log[2].id, 3U);
  EXPECT_EQ(ToUtime(log[2].stamp), 10'002'000);
}

TEST_F(RecordingCanBusTest, DoesNotWriteWhatTheBusDidNotTake) {
  hub_.SetState(CanBusState::kDown);
  EXPECT_EQ(dut_->Send({.id = 1}), SendOutcome::kDropped);
  dut_.reset();
  EXPECT_TRUE(ReadCandumpLog(file_).empty());
}

TEST_F(RecordingCanBusTest, PassesEverythingElseThrough) {
  const std::vector<CanFilter> filters{{.id = 5, .mask = 0x7FF}};
  dut_->SetFilters(filters);
  peer_->Send({.id = 4});
  peer_->Send({.id = 5});
  EXPECT_EQ(dut_->Receive()->id, 5U);
  EXPECT_EQ(dut_->counters().rx, 1U);
  EXPECT_EQ(dut_->state(), CanBusState::kUp);
  EXPECT_EQ(dut_->url(), "inproc:hub");
  EXPECT_EQ(dut_->PollDescriptor(), -1);
}

}  // namespace
}  // namespace eod
