#pragma once

#include <bit>
#include <cassert>
#include <cstdint>
#include <cstring>
#include <span>

#include "dbc/database.h"

namespace eod::dbc {

static_assert(std::endian::native == std::endian::little, "byte swaps assume a little-endian host");

/// Where the bits of one signal are, compiled at load: a 64-bit load, a shift, a mask, a scale.
/// Decode and encode neither allocate nor throw.
class SignalPlan {
 public:
  /// Throws std::runtime_error if the signal does not fit into `message_length` bytes, or if its
  /// scale is zero or not finite.
  SignalPlan(const Signal& signal, int message_length);

  /// Raw value, sign-extended; of an unsigned 64-bit signal and of a float the bare bits.
  /// `payload` must have the message's length at least.
  int64_t DecodeRaw(std::span<const uint8_t> payload) const {
    assert(payload.size() >= static_cast<size_t>(first_byte_ + byte_count_));
    const uint8_t* window = payload.data() + first_byte_;
    const uint64_t bits =
        window_ == Window::kEight ? LoadEight(window) >> shift_ : LoadRare(window);
    // Two's complement: the sign bit weighs minus what it would weigh unsigned.
    return static_cast<int64_t>(((bits & mask_) ^ sign_) - sign_);
  }
  /// Writes the raw value's low bits; other bits of `payload` stay.
  void EncodeRaw(int64_t raw, std::span<uint8_t> payload) const;

  /// raw * factor + offset. A float signal that holds no finite number gives `offset`.
  double ToPhysical(int64_t raw) const {
    return is_plain_ ? static_cast<double>(raw) * factor_ + offset_ : ToPhysicalRare(raw);
  }
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

  uint64_t LoadEight(const uint8_t* window) const {
    uint64_t word = 0;
    std::memcpy(&word, window, sizeof word);
    return big_endian_ ? __builtin_bswap64(word) : word;
  }
  uint64_t LoadShort(const uint8_t* window) const;
  /// The signal's bits, right-aligned, out of a short window or one of nine bytes.
  uint64_t LoadRare(const uint8_t* window) const;
  void StoreEight(uint64_t word, uint8_t* window) const;
  void StoreShort(uint64_t word, uint8_t* window) const;
  void StoreNine(uint64_t bits, uint8_t* window) const;
  double ToPhysicalRare(int64_t raw) const;

  Window window_ = Window::kEight;
  uint8_t byte_count_ = 8;   ///< of the window, the ninth byte excluded
  bool big_endian_ = false;  ///< window is loaded most significant byte first
  bool is_signed_ = false;
  bool is_plain_ = true;  ///< an integer that int64_t holds
  ValueType type_ = ValueType::kInteger;
  uint8_t length_ = 0;       ///< [bit]
  uint8_t shift_ = 0;        ///< of the signal's least significant bit in the window
  uint16_t first_byte_ = 0;  ///< of the window in the payload
  uint64_t mask_ = 0;        ///< of the signal's bits, right-aligned
  uint64_t sign_ = 0;        ///< its sign bit, 0 if it has none
  double factor_ = 1;
  double offset_ = 0;
  int64_t raw_min_ = 0;
  int64_t raw_max_ = 0;
};

}  // namespace eod::dbc
