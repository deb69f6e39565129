#pragma once

#include <cstdint>
#include <span>

#include "dbc/database.h"

namespace eod::dbc {

/// Where the bits of one signal are, compiled at load: a 64-bit load, a shift, a mask, a scale.
/// Decode and encode neither allocate nor throw.
class SignalPlan {
 public:
  /// Throws std::runtime_error if the signal does not fit into `message_length` bytes, or if its
  /// scale is zero or not finite.
  SignalPlan(const Signal& signal, int message_length);

  /// Raw value, sign-extended; of an unsigned 64-bit signal and of a float the bare bits.
  /// `payload` must have the message's length at least.
  int64_t DecodeRaw(std::span<const uint8_t> payload) const;
  /// Writes the raw value's low bits; other bits of `payload` stay.
  void EncodeRaw(int64_t raw, std::span<uint8_t> payload) const;

  /// raw * factor + offset. A float signal that holds no finite number gives `offset`.
  double ToPhysical(int64_t raw) const;
  /// Nearest raw value, saturated to what the bits can hold. NaN gives the raw value of 0.
  int64_t ToRaw(double physical) const;

  /// Range of what the bits can hold; an unsigned 64-bit signal reports INT64_MAX.
  int64_t raw_min() const { return raw_min_; }
  int64_t raw_max() const { return raw_max_; }
  bool is_float() const { return type_ != ValueType::kInteger; }

 private:
  /// The signal's bits lie in a window of 8 bytes, of fewer (short message), or of 9 (64 bits that
  /// start within a byte).
  enum class Window : uint8_t { kEight, kShort, kNine };

  uint64_t Load(const uint8_t* window) const;
  void Store(uint64_t word, uint8_t* window) const;

  Window window_ = Window::kEight;
  uint8_t byte_count_ = 8;   ///< of the window, the ninth byte excluded
  bool big_endian_ = false;  ///< window is loaded most significant byte first
  bool is_signed_ = false;
  ValueType type_ = ValueType::kInteger;
  uint8_t length_ = 0;       ///< [bit]
  uint8_t shift_ = 0;        ///< of the signal's least significant bit in the window
  uint16_t first_byte_ = 0;  ///< of the window in the payload
  double factor_ = 1;
  double offset_ = 0;
  int64_t raw_min_ = 0;
  int64_t raw_max_ = 0;
};

}  // namespace eod::dbc
