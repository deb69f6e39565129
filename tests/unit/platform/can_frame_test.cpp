#include "platform/can_frame.h"

#include <gtest/gtest.h>

#include "platform/can_filter.h"
#include "platform/socketcan_frame.h"

namespace eod {
namespace {

std::vector<CanFrame> EveryKind() {
  return {{.id = 0x7FF, .length = 8, .data = {1, 2, 3, 4, 5, 6, 7, 8}},
          {.id = 0x7FF, .extended = true},
          {.id = 0x123, .remote = true, .length = 8},
          {.id = 0x40, .error = true, .length = 8},
          {.id = 0x1FFFFFFF, .extended = true, .fd = true, .bit_rate_switch = true, .length = 64},
          {.id = 0, .fd = true, .error_state_indicator = true, .length = 12}};
}

TEST(CanFrame, IsWellFormedInEveryKind) {
  for (const CanFrame& frame : EveryKind()) EXPECT_TRUE(IsWellFormed(frame)) << frame.id;
}

TEST(CanFrame, IsNotWellFormedOutsideItsKindsRange) {
  EXPECT_FALSE(IsWellFormed({.id = 0x800}));
  EXPECT_FALSE(IsWellFormed({.id = 0x20000000, .extended = true}));
  EXPECT_FALSE(IsWellFormed({.id = 1, .length = 9}));
  EXPECT_FALSE(IsWellFormed({.id = 1, .bit_rate_switch = true}));
  EXPECT_FALSE(IsWellFormed({.id = 1, .fd = true, .length = 9}));
  EXPECT_FALSE(IsWellFormed({.id = 1, .fd = true, .length = 65}));
  EXPECT_FALSE(IsWellFormed({.id = 1, .remote = true, .fd = true}));
}

TEST(CanFrame, CountsWorstCaseBits) {
  // Tindell: 8 * 8 + 34 + 13 + floor((34 + 64 - 1) / 4) = 135 bits with 11-bit identifiers,
  // 8 * 8 + 54 + 13 + floor((54 + 64 - 1) / 4) = 160 with 29.
  EXPECT_EQ(WorstCaseBits({.id = 1, .length = 8}), 135);
  EXPECT_EQ(WorstCaseBits({.id = 1, .extended = true, .length = 8}), 160);
  // A remote frame carries no data: 34 + 13 + floor(33 / 4) = 55.
  EXPECT_EQ(WorstCaseBits({.id = 1, .remote = true, .length = 8}), 55);
}

TEST(CanFrame, SurvivesTheWayThroughSocketCan) {
  for (const CanFrame& frame : EveryKind()) {
    const canfd_frame raw = ToSocketCan(frame);
    const std::span bytes(reinterpret_cast<const uint8_t*>(&raw), SocketCanSize(frame));
    const auto back = FromSocketCan(bytes);
    ASSERT_TRUE(back.has_value()) << frame.id;
    EXPECT_TRUE(SameOnWire(*back, frame)) << frame.id;
  }
}

TEST(CanFrame, IsNotMadeOfBytesOfAnotherSize) {
  const std::array<uint8_t, CANFD_MTU> bytes{};
  EXPECT_FALSE(FromSocketCan(std::span(bytes).first(CAN_MTU - 1)).has_value());
  EXPECT_FALSE(FromSocketCan(std::span(bytes).first(CANFD_MTU - 1)).has_value());
}

TEST(CanFilter, AcceptsByMaskWithinItsKind) {
  const std::vector<CanFilter> filters{{.id = 0x120, .mask = 0x7F0},
                                       {.id = 0x55, .mask = 0x1FFFFFFF, .extended = true}};
  EXPECT_TRUE(IsAccepted(filters, {.id = 0x12F}));
  EXPECT_FALSE(IsAccepted(filters, {.id = 0x130}));
  EXPECT_FALSE(IsAccepted(filters, {.id = 0x12F, .extended = true}));
  EXPECT_TRUE(IsAccepted(filters, {.id = 0x55, .extended = true}));
  EXPECT_FALSE(IsAccepted(filters, {.id = 0x55}));
}

TEST(CanFilter, AcceptsEverythingWithoutFilters) { EXPECT_TRUE(IsAccepted({}, {.id = 0x12F})); }

}  // namespace
}  // namespace eod
