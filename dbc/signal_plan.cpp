#include "dbc/signal_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace eod::dbc {
namespace {

constexpr int kWordBytes = 8;
constexpr int kWordBits = 64;

constexpr uint64_t LowBits(int count) {
  return count >= kWordBits ? ~uint64_t{0} : (uint64_t{1} << count) - 1;
}

/// Bits of a signal as a run in its window: Intel counts from the first byte's LSB upwards,
/// Motorola from the first byte's MSB downwards.
struct BitRun {
  int first_byte;
  int lead;  ///< bits of the first byte that precede the run
};

BitRun Locate(const Signal& signal) {
  const int bit = signal.start_bit % 8;
  const bool is_intel = signal.byte_order == ByteOrder::kIntel;
  return {signal.start_bit / 8, is_intel ? bit : 7 - bit};
}

[[noreturn]] void Fail(const Signal& signal, const std::string& why) {
  throw std::runtime_error(fmt::format("signal {}: {}", signal.name, why));
}

void CheckFits(const Signal& signal, const BitRun& run, int message_length) {
  if (signal.length < 1 || signal.length > kWordBits) {
    Fail(signal, fmt::format("length {} bit, allowed 1..64", signal.length));
  }
  const int last_byte = run.first_byte + (run.lead + signal.length - 1) / 8;
  if (signal.start_bit < 0 || last_byte >= message_length) {
    Fail(signal,
         fmt::format("start bit {}, length {} bit: reaches byte {} of a message of {} bytes",
                     signal.start_bit, signal.length, last_byte, message_length));
  }
  const int float_length = signal.value_type == ValueType::kFloat    ? 32
                           : signal.value_type == ValueType::kDouble ? 64
                                                                     : signal.length;
  if (signal.length != float_length) {
    Fail(signal,
         fmt::format("floating-point signal of {} bit, needs {}", signal.length, float_length));
  }
  if (signal.factor == 0 || !std::isfinite(signal.factor) || !std::isfinite(signal.offset)) {
    Fail(signal, fmt::format("scale ({},{}): the factor must be a number other than 0",
                             signal.factor, signal.offset));
  }
}

}  // namespace

SignalPlan::SignalPlan(const Signal& signal, int message_length)
    : big_endian_(signal.byte_order == ByteOrder::kMotorola),
      is_signed_(signal.is_signed),
      type_(signal.value_type),
      length_(static_cast<uint8_t>(signal.length)),
      factor_(signal.factor),
      offset_(signal.offset) {
  const BitRun run = Locate(signal);
  CheckFits(signal, run, message_length);

  int first_byte = run.first_byte;
  int lead = run.lead;
  if (lead + signal.length > kWordBits) {
    window_ = Window::kNine;
  } else if (message_length >= kWordBytes) {
    // Shift the window down where it would reach beyond the message.
    first_byte = std::min(first_byte, message_length - kWordBytes);
    lead += 8 * (run.first_byte - first_byte);
  } else {
    window_ = Window::kShort;
    byte_count_ = static_cast<uint8_t>((lead + signal.length + 7) / 8);
  }
  const int window_bits = 8 * (byte_count_ + (window_ == Window::kNine ? 1 : 0));
  first_byte_ = static_cast<uint16_t>(first_byte);
  shift_ = static_cast<uint8_t>(big_endian_ ? window_bits - lead - signal.length : lead);

  is_plain_ = !is_float() && (is_signed_ || length_ < kWordBits);
  mask_ = LowBits(length_);
  sign_ = is_signed_ ? uint64_t{1} << (length_ - 1) : 0;
  raw_max_ = static_cast<int64_t>(LowBits(is_signed_ ? length_ - 1 : std::min(63, signal.length)));
  raw_min_ = is_signed_ ? -raw_max_ - 1 : 0;
}

uint64_t SignalPlan::LoadShort(const uint8_t* window) const {
  uint64_t word = 0;
  for (int i = 0; i < byte_count_; ++i) {
    const int position = big_endian_ ? byte_count_ - 1 - i : i;
    word |= uint64_t{window[i]} << (8 * position);
  }
  return word;
}

uint64_t SignalPlan::LoadRare(const uint8_t* window) const {
  if (window_ == Window::kShort) return LoadShort(window) >> shift_;
  // The ninth byte is the most significant one for Intel, the least significant for Motorola.
  const uint64_t word = LoadEight(window);
  const uint8_t ninth = window[kWordBytes];
  return big_endian_ ? word << (8 - shift_) | ninth >> shift_
                     : word >> shift_ | uint64_t{ninth} << (kWordBits - shift_);
}

void SignalPlan::StoreEight(uint64_t word, uint8_t* window) const {
  if (big_endian_) word = __builtin_bswap64(word);
  std::memcpy(window, &word, sizeof word);
}

void SignalPlan::StoreShort(uint64_t word, uint8_t* window) const {
  for (int i = 0; i < byte_count_; ++i) {
    const int position = big_endian_ ? byte_count_ - 1 - i : i;
    window[i] = static_cast<uint8_t>(word >> (8 * position));
  }
}

void SignalPlan::StoreNine(uint64_t bits, uint8_t* window) const {
  const uint64_t word = LoadEight(window);
  uint8_t& ninth = window[kWordBytes];
  if (big_endian_) {
    const int over = 8 - shift_;  // bits of the signal in the ninth byte
    StoreEight((word & ~(mask_ >> over)) | bits >> over, window);
    ninth = static_cast<uint8_t>((ninth & LowBits(shift_)) | bits << shift_);
  } else {
    const int under = kWordBits - shift_;  // bits of the signal in the first eight bytes
    StoreEight((word & LowBits(shift_)) | bits << shift_, window);
    ninth = static_cast<uint8_t>((ninth & ~(mask_ >> under)) | bits >> under);
  }
}

void SignalPlan::EncodeRaw(int64_t raw, std::span<uint8_t> payload) const {
  assert(payload.size() >= static_cast<size_t>(first_byte_ + byte_count_));
  uint8_t* window = payload.data() + first_byte_;
  const uint64_t bits = static_cast<uint64_t>(raw) & mask_;
  const uint64_t others = ~(mask_ << shift_);
  switch (window_) {
    case Window::kEight:
      return StoreEight((LoadEight(window) & others) | bits << shift_, window);
    case Window::kShort:
      return StoreShort((LoadShort(window) & others) | bits << shift_, window);
    case Window::kNine:
      return StoreNine(bits, window);
  }
}

double SignalPlan::ToPhysicalRare(int64_t raw) const {
  double value = 0;
  if (type_ == ValueType::kInteger) {
    value = static_cast<double>(static_cast<uint64_t>(raw));
  } else {
    value = type_ == ValueType::kFloat
                ? static_cast<double>(std::bit_cast<float>(static_cast<uint32_t>(raw)))
                : std::bit_cast<double>(raw);
    if (!std::isfinite(value * factor_)) value = 0;
  }
  return value * factor_ + offset_;
}

int64_t SignalPlan::ToRaw(double physical) const {
  if (std::isnan(physical)) physical = 0;
  double value = (physical - offset_) / factor_;
  if (type_ == ValueType::kDouble) {
    constexpr double kLargest = std::numeric_limits<double>::max();
    return std::bit_cast<int64_t>(std::clamp(value, -kLargest, kLargest));
  }
  if (type_ == ValueType::kFloat) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    const auto narrow = static_cast<float>(std::clamp(value, -kLargest, kLargest));
    const auto bits = std::bit_cast<uint32_t>(narrow);
    return is_signed_ ? static_cast<int32_t>(bits) : static_cast<int64_t>(bits);
  }
  value = std::round(value);
  if (!is_signed_ && length_ == kWordBits) {
    if (value >= 0x1p64) return static_cast<int64_t>(~uint64_t{0});
    return value > 0 ? static_cast<int64_t>(static_cast<uint64_t>(value)) : 0;
  }
  if (value >= static_cast<double>(raw_max_)) return raw_max_;
  if (value <= static_cast<double>(raw_min_)) return raw_min_;
  return static_cast<int64_t>(value);
}

}  // namespace eod::dbc
