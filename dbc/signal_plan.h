#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dbc/database.h"

namespace eod::dbc {

/// Where the bits of one signal are, compiled at load: a 64-bit load, a shift, a mask, a scale.
/// Decode and encode neither allocate nor throw.
class SignalPlan {
 public:
  /// Throws std::runtime_error if the signal does not fit into `message_length` bytes.
  SignalPlan(const Signal& signal, int message_length);

  /// Raw value, sign-extended. `payload` must have the message's length at least.
  int64_t DecodeRaw(std::span<const uint8_t> payload) const;
  /// Writes the raw value's low bits; other bits of `payload` stay.
  void EncodeRaw(int64_t raw, std::span<uint8_t> payload) const;

  double ToPhysical(int64_t raw) const;
  /// Nearest raw value, saturated to what the bits can hold. NaN gives the raw value of 0.
  int64_t ToRaw(double physical) const;

  int64_t raw_min() const { return raw_min_; }
  int64_t raw_max() const { return raw_max_; }

 private:
  int first_byte_ = 0;  ///< of the window that is loaded
  int byte_count_ = 0;  ///< 1..9
  int shift_ = 0;
  int length_ = 0;
  bool big_endian_ = false;
  bool is_signed_ = false;
  double factor_ = 1;
  double offset_ = 0;
  int64_t raw_min_ = 0;
  int64_t raw_max_ = 0;
};

}  // namespace eod::dbc
