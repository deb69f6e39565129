#include "dbc/signal_plan.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/unit/dbc/samples.h"

namespace eod::dbc {
namespace {

using Payload = std::array<uint8_t, 64>;

Signal MakeSignal(ByteOrder order, int start_bit, int length, bool is_signed = false) {
  Signal signal;
  signal.name = "S";
  signal.byte_order = order;
  signal.start_bit = start_bit;
  signal.length = length;
  signal.is_signed = is_signed;
  return signal;
}

/// Position of bit `i` (0 = least significant) of the signal, as byte * 8 + bit, walked bit by bit:
/// Intel goes up from the LSB; Motorola goes down from the MSB, and from bit 0 to bit 7 of the next
/// byte.
int BitPosition(const Signal& signal, int i) {
  if (signal.byte_order == ByteOrder::kIntel) return signal.start_bit + i;
  int position = signal.start_bit;
  for (int step = 0; step < signal.length - 1 - i; ++step) {
    position = position % 8 == 0 ? position + 15 : position - 1;
  }
  return position;
}

int64_t ReferenceDecode(const Signal& signal, std::span<const uint8_t> payload) {
  uint64_t raw = 0;
  for (int i = 0; i < signal.length; ++i) {
    const int at = BitPosition(signal, i);
    const bool is_set = (payload[static_cast<size_t>(at / 8)] >> (at % 8) & 1) != 0;
    if (is_set) raw |= uint64_t{1} << i;
  }
  const bool is_negative = signal.is_signed && (raw >> (signal.length - 1) & 1) != 0;
  if (is_negative && signal.length < 64) raw |= ~uint64_t{0} << signal.length;
  return static_cast<int64_t>(raw);
}

void ReferenceEncode(const Signal& signal, int64_t raw, std::span<uint8_t> payload) {
  for (int i = 0; i < signal.length; ++i) {
    const int at = BitPosition(signal, i);
    uint8_t& byte = payload[static_cast<size_t>(at / 8)];
    const auto mask = static_cast<uint8_t>(1u << (at % 8));
    byte = static_cast<uint8_t>((static_cast<uint64_t>(raw) >> i & 1) != 0 ? byte | mask
                                                                           : byte & ~mask);
  }
}

bool Fits(const Signal& signal, int message_length) {
  const int last =
      BitPosition(signal, signal.byte_order == ByteOrder::kIntel ? signal.length - 1 : 0);
  return last < 8 * message_length;
}

TEST(SignalPlan, AgreesWithABitByBitReferenceOnRandomLayouts) {
  Dice dice(1);
  int cases = 0;
  int nine_byte_windows = 0;
  while (cases < 200'000) {
    const auto order = dice.Roll(0, 1) == 0 ? ByteOrder::kIntel : ByteOrder::kMotorola;
    const int message_length = dice.Roll(1, 64);
    const Signal signal = MakeSignal(order, dice.Roll(0, 8 * message_length - 1), dice.Roll(1, 64),
                                     dice.Roll(0, 1) == 1);
    if (!Fits(signal, message_length)) continue;
    ++cases;
    const SignalPlan dut(signal, message_length);

    Payload payload{};
    for (uint8_t& byte : payload) byte = static_cast<uint8_t>(dice.Bits());
    const std::span<uint8_t> bytes{payload.data(), static_cast<size_t>(message_length)};
    ASSERT_EQ(dut.DecodeRaw(bytes), ReferenceDecode(signal, bytes))
        << (order == ByteOrder::kIntel ? "Intel " : "Motorola ") << signal.start_bit << '|'
        << signal.length << " in " << message_length;

    const auto raw = static_cast<int64_t>(dice.Bits());
    Payload expected = payload;
    ReferenceEncode(signal, raw, expected);
    dut.EncodeRaw(raw, bytes);
    ASSERT_EQ(payload, expected) << (order == ByteOrder::kIntel ? "Intel " : "Motorola ")
                                 << signal.start_bit << '|' << signal.length << " in "
                                 << message_length;
    const int lead = order == ByteOrder::kIntel ? signal.start_bit % 8 : 7 - signal.start_bit % 8;
    if (lead + signal.length > 64) ++nine_byte_windows;
  }
  EXPECT_GT(nine_byte_windows, 1000);
}

TEST(SignalPlan, RoundTripsEveryRawValueOfSmallSignals) {
  for (const ByteOrder order : {ByteOrder::kIntel, ByteOrder::kMotorola}) {
    for (const bool is_signed : {false, true}) {
      for (int length = 1; length <= 12; ++length) {
        for (int start = 0; start < 32; ++start) {
          const Signal signal = MakeSignal(order, start, length, is_signed);
          if (!Fits(signal, 6)) continue;
          const SignalPlan dut(signal, 6);
          for (int64_t raw = dut.raw_min(); raw <= dut.raw_max(); ++raw) {
            Payload payload{};
            dut.EncodeRaw(raw, payload);
            ASSERT_EQ(dut.DecodeRaw(payload), raw) << start << '|' << length;
          }
        }
      }
    }
  }
}

TEST(SignalPlan, RoundTripsPhysicalValuesOfEveryRaw) {
  Signal signal = MakeSignal(ByteOrder::kIntel, 4, 12, true);
  signal.factor = -0.1;
  signal.offset = 40;
  const SignalPlan dut(signal, 8);
  for (int64_t raw = dut.raw_min(); raw <= dut.raw_max(); ++raw) {
    ASSERT_EQ(dut.ToRaw(dut.ToPhysical(raw)), raw);
  }
}

TEST(SignalPlan, SaturatesAndNeverTakesNan) {
  Signal signal = MakeSignal(ByteOrder::kIntel, 0, 8, false);
  signal.factor = 0.5;
  signal.offset = -40;
  const SignalPlan dut(signal, 8);
  EXPECT_EQ(dut.ToRaw(1e300), 255);
  EXPECT_EQ(dut.ToRaw(-1e300), 0);
  EXPECT_EQ(dut.ToRaw(std::numeric_limits<double>::infinity()), 255);
  EXPECT_EQ(dut.ToRaw(std::nan("")), 80);  // (0 - -40) / 0.5
  EXPECT_EQ(dut.ToRaw(0.26), 81);          // 80.52 rounds up
}

TEST(SignalPlan, HoldsTheWhole64BitRange) {
  const SignalPlan is_signed(MakeSignal(ByteOrder::kIntel, 0, 64, true), 8);
  EXPECT_EQ(is_signed.ToRaw(1e30), std::numeric_limits<int64_t>::max());
  EXPECT_EQ(is_signed.ToRaw(-1e30), std::numeric_limits<int64_t>::min());
  const SignalPlan is_unsigned(MakeSignal(ByteOrder::kMotorola, 7, 64, false), 8);
  EXPECT_EQ(is_unsigned.ToPhysical(is_unsigned.ToRaw(0x1p63)), 0x1p63);
  EXPECT_EQ(static_cast<uint64_t>(is_unsigned.ToRaw(1e30)), ~uint64_t{0});
  EXPECT_EQ(is_unsigned.ToRaw(-1), 0);
}

TEST(SignalPlan, ReadsFloatsAndNeverHandsOutNan) {
  Signal signal = MakeSignal(ByteOrder::kIntel, 0, 32, true);
  signal.value_type = ValueType::kFloat;
  signal.factor = 2;
  signal.offset = 1;
  const SignalPlan dut(signal, 8);
  Payload payload{};
  dut.EncodeRaw(dut.ToRaw(-6), payload);
  EXPECT_EQ(dut.ToPhysical(dut.DecodeRaw(payload)), -6);
  EXPECT_EQ(dut.DecodeRaw(payload), static_cast<int32_t>(std::bit_cast<uint32_t>(-3.5f)));
  dut.EncodeRaw(std::bit_cast<int32_t>(std::nanf("")), payload);
  EXPECT_EQ(dut.ToPhysical(dut.DecodeRaw(payload)), 1);
  EXPECT_TRUE(std::isfinite(dut.ToPhysical(dut.ToRaw(1e300))));

  signal.length = 64;
  signal.value_type = ValueType::kDouble;
  const SignalPlan wide(signal, 8);
  EXPECT_EQ(wide.ToPhysical(wide.ToRaw(0.75)), 0.75);
  EXPECT_EQ(wide.ToPhysical(std::bit_cast<int64_t>(std::numeric_limits<double>::infinity())), 1);
}

TEST(SignalPlan, RefusesWhatDoesNotFit) {
  EXPECT_THROW(SignalPlan(MakeSignal(ByteOrder::kIntel, 57, 8), 8), std::runtime_error);
  EXPECT_THROW(SignalPlan(MakeSignal(ByteOrder::kMotorola, 56, 2), 8), std::runtime_error);
  EXPECT_THROW(SignalPlan(MakeSignal(ByteOrder::kIntel, 0, 65), 64), std::runtime_error);
  EXPECT_THROW(SignalPlan(MakeSignal(ByteOrder::kIntel, 0, 0), 8), std::runtime_error);
  Signal signal = MakeSignal(ByteOrder::kIntel, 0, 8);
  signal.factor = 0;
  EXPECT_THROW(SignalPlan(signal, 8), std::runtime_error);
  signal.factor = 1;
  signal.value_type = ValueType::kFloat;
  EXPECT_THROW(SignalPlan(signal, 8), std::runtime_error);
}

}  // namespace
}  // namespace eod::dbc
