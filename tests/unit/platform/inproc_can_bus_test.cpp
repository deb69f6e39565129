#include "platform/inproc_can_bus.h"

#include <gtest/gtest.h>

#include "platform/open_can_bus.h"

namespace eod {
namespace {

constexpr CanFrame kFrame{.id = 0x123, .length = 1, .data = {7}};

class InprocCanHubTest : public testing::Test {
 protected:
  ManualClock clock_{TimePoint{std::chrono::seconds{5}}};
  InprocCanHub dut_{"station"};
  std::unique_ptr<CanBus> a_ = dut_.Connect(clock_);
  std::unique_ptr<CanBus> b_ = dut_.Connect(clock_);
};

TEST_F(InprocCanHubTest, StampsAFrameWithTheMomentOfSending) {
  a_->Send(kFrame);
  clock_.Advance(std::chrono::milliseconds{3});
  EXPECT_EQ(b_->Receive()->stamp, TimePoint{std::chrono::seconds{5}});
}

TEST_F(InprocCanHubTest, HasNothingToPoll) { EXPECT_EQ(a_->PollDescriptor(), -1); }

TEST_F(InprocCanHubTest, MayGoBeforeItsNodes) {
  std::unique_ptr<CanBus> c;
  std::unique_ptr<CanBus> d;
  {
    InprocCanHub hub;
    c = hub.Connect(clock_);
    d = hub.Connect(clock_);
  }
  c->Send(kFrame);
  EXPECT_TRUE(d->Receive().has_value());
}

TEST_F(InprocCanHubTest, ForgetsANodeThatWent) {
  b_.reset();
  EXPECT_EQ(a_->Send(kFrame), SendOutcome::kSent);
}

TEST_F(InprocCanHubTest, DropsAndCountsWhileTheBusIsOff) {
  dut_.SetState(CanBusState::kBusOff);
  EXPECT_EQ(a_->state(), CanBusState::kBusOff);
  EXPECT_EQ(a_->Send(kFrame), SendOutcome::kDropped);
  EXPECT_EQ(a_->counters().tx_dropped, 1U);
  dut_.SetState(CanBusState::kUp);
  EXPECT_FALSE(b_->Receive().has_value()) << "a dropped frame is never sent late";
  EXPECT_EQ(a_->counters().restarts, 1U);
  EXPECT_EQ(a_->Send(kFrame), SendOutcome::kSent);
}

TEST_F(InprocCanHubTest, KeepsOrderThroughAQueueThatNeverEmpties) {
  uint32_t expected = 0;
  a_->Send({.id = 0});
  for (uint32_t sent = 1; sent < 3 * kInprocQueueLength; ++sent) {
    a_->Send({.id = sent % 0x800});
    ASSERT_EQ(b_->Receive()->id, expected++ % 0x800);
  }
  EXPECT_EQ(b_->counters().rx_lost, 0U);
}

TEST_F(InprocCanHubTest, IsSharedByNameThroughItsUrl) {
  const auto c = OpenCanBus("inproc:shared", clock_);
  const auto d = OpenCanBus("inproc:shared", clock_);
  const auto elsewhere = OpenCanBus("inproc:other", clock_);
  c->Send(kFrame);
  EXPECT_TRUE(d->Receive().has_value());
  EXPECT_FALSE(elsewhere->Receive().has_value());
}

}  // namespace
}  // namespace eod
