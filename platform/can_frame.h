#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "platform/time.h"

namespace eod {

/// One CAN 2.0 or CAN FD frame, with the moment it was received.
struct CanFrame {
  uint32_t id = 0;               ///< identifier without flag bits: 11 bit, or 29 bit if `extended`
  bool extended = false;         ///< 29-bit identifier
  bool remote = false;           ///< remote request; `length` is the requested length, no data
  bool error = false;            ///< controller's error report; `id` holds the error class bits
  bool fd = false;               ///< CAN FD frame, up to 64 bytes
  bool bit_rate_switch = false;  ///< FD only
  bool error_state_indicator = false;  ///< FD only
  uint8_t length = 0;                  ///< bytes of data: 0..8, FD 0..64
  std::array<uint8_t, 64> data{};      ///< bytes beyond `length` are zero
  TimePoint stamp{};                   ///< reception; unset in a frame to be sent

  std::span<const uint8_t> payload() const { return {data.data(), remote ? size_t{0} : length}; }

  /// Equal on the wire: everything but the time stamp.
  friend bool SameOnWire(const CanFrame& a, const CanFrame& b) {
    return a.id == b.id && a.extended == b.extended && a.remote == b.remote && a.error == b.error &&
           a.fd == b.fd && a.bit_rate_switch == b.bit_rate_switch &&
           a.error_state_indicator == b.error_state_indicator && a.length == b.length &&
           (a.remote || a.data == b.data);
  }
};

/// True if CAN can carry the frame: identifier and length within its kind's range, no FD remote.
/// Source: ISO 11898-1.
constexpr bool IsWellFormed(const CanFrame& frame) {
  if (frame.error) return frame.id <= 0x1FFFFFFF && frame.length <= 8;
  const bool is_id_in_range = frame.id <= (frame.extended ? 0x1FFFFFFFU : 0x7FFU);
  if (!frame.fd) {
    return is_id_in_range && frame.length <= 8 && !frame.bit_rate_switch &&
           !frame.error_state_indicator;
  }
  const int n = frame.length;
  const bool is_fd_length =
      n <= 8 || n == 12 || n == 16 || n == 20 || n == 24 || n == 32 || n == 48 || n == 64;
  return is_id_in_range && is_fd_length && !frame.remote;
}

/// Bits of a frame on the wire, worst-case bit stuffing included, for the bus load (classic frames;
/// FD data counted at the nominal rate). Source: ISO 11898-1 frame format; Tindell's worst case,
/// 8 n + g + 13 + floor((g + 8 n - 1) / 4), g = 34 standard, 54 extended.
constexpr int WorstCaseBits(const CanFrame& frame) {
  const int data_bits = frame.remote ? 0 : 8 * frame.length;
  const int stuffable = (frame.extended ? 54 : 34) + data_bits;
  return stuffable + 13 + (stuffable - 1) / 4;
}

}  // namespace eod
