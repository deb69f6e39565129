#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/contract/can_bus_medium.h"

namespace eod {
namespace {

/// What every form of CanBus promises.
class CanBusContract : public testing::TestWithParam<Medium> {
 protected:
  std::unique_ptr<CanBus> Connect() { return OpenCanBus(GetParam().url, clock_); }

  SteadyClock clock_;
  std::unique_ptr<CanBus> a_ = Connect();
  std::unique_ptr<CanBus> b_ = Connect();
};

constexpr CanFrame kMarker{.id = 0x7FF, .length = 1, .data = {0xEE}};

std::vector<CanFrame> EveryKind() {
  CanFrame full_fd{
      .id = 0x1FFFFFFF, .extended = true, .fd = true, .bit_rate_switch = true, .length = 64};
  std::iota(full_fd.data.begin(), full_fd.data.end(), uint8_t{0});
  return {
      {.id = 0},
      {.id = 0x7FF, .length = 8, .data = {1, 2, 3, 4, 5, 6, 7, 8}},
      {.id = 0x123, .extended = true, .length = 3, .data = {0, 0, 9}},
      {.id = 0x1FFFFFFF, .extended = true, .length = 8, .data = {0xFF, 0, 0xFF}},
      {.id = 0x321, .remote = true, .length = 5},
      {.id = 0x1ABCDEF0, .extended = true, .remote = true},
      {.id = 0x123, .fd = true},
      {.id = 0x123, .fd = true, .error_state_indicator = true, .length = 12, .data = {7}},
      full_fd,
  };
}

TEST_P(CanBusContract, CarriesEveryKindOfFrameUnchanged) {
  for (const CanFrame& frame : EveryKind()) {
    SCOPED_TRACE(testing::Message() << std::hex << frame.id << " fd " << frame.fd);
    ASSERT_EQ(a_->Send(frame), SendOutcome::kSent);
    const auto received = Await(*b_);
    ASSERT_TRUE(received.has_value());
    EXPECT_TRUE(SameOnWire(*received, frame));
  }
}

TEST_P(CanBusContract, HasNothingWhenNothingWasSent) {
  EXPECT_FALSE(a_->Receive().has_value());
  EXPECT_EQ(a_->counters().rx, 0U);
}

TEST_P(CanBusContract, DeliversToEveryOtherNodeInOrder) {
  const auto c = Connect();
  for (uint32_t id = 1; id <= 20; ++id) a_->Send({.id = id});
  for (CanBus* node : {b_.get(), c.get()}) {
    for (uint32_t id = 1; id <= 20; ++id) {
      const auto received = Await(*node);
      ASSERT_TRUE(received.has_value());
      EXPECT_EQ(received->id, id);
    }
    EXPECT_FALSE(node->Receive().has_value());
  }
}

TEST_P(CanBusContract, NeverReturnsANodesOwnFrames) {
  a_->Send({.id = 1});
  ASSERT_EQ(Await(*b_)->id, 1U);
  b_->Send(kMarker);
  // Had a_ received its own frame, that would come first.
  const auto received = Await(*a_);
  ASSERT_TRUE(received.has_value());
  EXPECT_TRUE(SameOnWire(*received, kMarker));
  EXPECT_EQ(a_->counters().rx, 1U);
}

TEST_P(CanBusContract, FiltersByIdentifierAndMask) {
  const std::vector<CanFilter> filters{{.id = 0x120, .mask = 0x7F0}, {.id = 0x7FF, .mask = 0x7FF}};
  b_->SetFilters(filters);
  for (const uint32_t id : {0x11FU, 0x130U, 0x12AU}) a_->Send({.id = id});
  a_->Send(kMarker);
  EXPECT_EQ(Await(*b_)->id, 0x12AU);
  EXPECT_EQ(Await(*b_)->id, kMarker.id);
  EXPECT_EQ(b_->counters().rx, 2U);
}

TEST_P(CanBusContract, KeepsStandardAndExtendedOfOneNumberApart) {
  const std::vector<CanFilter> extended_only{{.id = 0x123, .mask = 0x1FFFFFFF, .extended = true}};
  b_->SetFilters(extended_only);
  a_->Send({.id = 0x123, .length = 1});
  a_->Send({.id = 0x123, .extended = true, .length = 2});
  const auto received = Await(*b_);
  ASSERT_TRUE(received.has_value());
  EXPECT_TRUE(received->extended);
  EXPECT_EQ(received->length, 2);
}

TEST_P(CanBusContract, AcceptsEverythingAgainWithoutFilters) {
  const std::vector<CanFilter> marker_only{{.id = 0x7FF, .mask = 0x7FF}};
  b_->SetFilters(marker_only);
  b_->SetFilters({});
  a_->Send({.id = 0x123, .extended = true});
  EXPECT_EQ(Await(*b_)->id, 0x123U);
}

TEST_P(CanBusContract, TakesMoreFiltersThanAKernelDoes) {
  std::vector<CanFilter> filters;  // CAN_RAW_FILTER_MAX is 512
  for (uint32_t id = 0; id < 600; ++id) filters.push_back({.id = id, .mask = 0x7FF});
  b_->SetFilters(filters);
  a_->Send({.id = 600});
  a_->Send({.id = 599});
  EXPECT_EQ(Await(*b_)->id, 599U);
}

TEST_P(CanBusContract, CountsWhatItSentAndReceived) {
  for (int i = 0; i < 7; ++i) a_->Send({.id = 1});
  for (int i = 0; i < 7; ++i) ASSERT_TRUE(Await(*b_).has_value());
  EXPECT_EQ(a_->counters().tx, 7U);
  EXPECT_EQ(b_->counters().rx, 7U);
  EXPECT_EQ(b_->counters().tx, 0U);
  EXPECT_EQ(b_->counters().rx_lost, 0U);
  EXPECT_EQ(b_->counters().malformed, 0U);
}

TEST_P(CanBusContract, DropsAndCountsWhatIsNoFrame) {
  EXPECT_EQ(a_->Send({.id = 0x800}), SendOutcome::kDropped);
  EXPECT_EQ(a_->Send({.id = 1, .length = 9}), SendOutcome::kDropped);
  EXPECT_EQ(a_->Send({.id = 1, .remote = true, .fd = true}), SendOutcome::kDropped);
  EXPECT_EQ(a_->Send({.id = 0x40, .error = true, .length = 8}), SendOutcome::kDropped);
  EXPECT_EQ(a_->counters().tx_dropped, 4U);
  EXPECT_EQ(a_->counters().tx, 0U);
  a_->Send(kMarker);
  EXPECT_TRUE(SameOnWire(*Await(*b_), kMarker));
}

TEST_P(CanBusContract, LosesNothingInABurst) {
  // Twenty bursts of 100 frames, each read only when it is complete: more than a step of the chain
  // ever sends at once.
  uint32_t next = 0;
  for (int burst = 0; burst < 20; ++burst) {
    for (uint32_t i = 0; i < 100; ++i) a_->Send({.id = (next + i) % 0x800, .length = 8});
    for (uint32_t i = 0; i < 100; ++i) {
      const auto received = Await(*b_);
      ASSERT_TRUE(received.has_value()) << next;
      ASSERT_EQ(received->id, next++ % 0x800);
    }
  }
  EXPECT_EQ(b_->counters().rx, 2000U);
  EXPECT_EQ(b_->counters().rx_lost, 0U);
}

TEST_P(CanBusContract, CountsWhatAFullQueueLost) {
  // More than any receive queue of ours holds. Lost are the newest; the marker that is sent when
  // there is room again brings the count of the losses before it.
  constexpr uint64_t kFlood = 30000;
  for (uint64_t i = 0; i < kFlood; ++i) ASSERT_EQ(a_->Send({.id = 1}), SendOutcome::kSent);
  uint64_t received = 0;
  while (b_->Receive()) ++received;
  a_->Send(kMarker);
  ASSERT_TRUE(Await(*b_).has_value());
  EXPECT_LT(received, kFlood);
  EXPECT_EQ(received + b_->counters().rx_lost, kFlood);
}

TEST_P(CanBusContract, StampsAFrameBetweenItsSendingAndItsReception) {
  // The kernel stamps by its wall clock, so a slew of that clock may show: 1 ms is generous.
  constexpr Duration kSlew = std::chrono::milliseconds{1};
  const TimePoint before = clock_.Now();
  a_->Send(kMarker);
  const auto received = Await(*b_);
  ASSERT_TRUE(received.has_value());
  EXPECT_GE(received->stamp, before - kSlew);
  EXPECT_LE(received->stamp, clock_.Now());
}

TEST_P(CanBusContract, IsUpAndKnowsItsUrl) {
  a_->Maintain(clock_.Now());
  EXPECT_EQ(a_->state(), CanBusState::kUp);
  EXPECT_EQ(a_->counters().restarts, 0U);
  EXPECT_EQ(a_->url(), GetParam().url);
}

INSTANTIATE_TEST_SUITE_P(Bus, CanBusContract, testing::ValuesIn(Mediums()),
                         [](const auto& medium) { return medium.param.name; });

}  // namespace
}  // namespace eod
