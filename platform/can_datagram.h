#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "platform/can_frame.h"

namespace eod {

/// A CAN frame as python-can's udp_multicast interface carries it: one datagram, a MessagePack map
/// of exactly eleven keys. Source: python-can 4, can/interfaces/udp_multicast/utils.py.
class CanDatagram {
 public:
  /// Encodes `frame`, sent at `now`.
  CanDatagram(const CanFrame& frame, TimePoint now);

  std::span<const uint8_t> bytes() const { return std::span(bytes_).first(size_); }

 private:
  static constexpr size_t kCapacity = 320;  // 165 of keys and values around up to 64 of data
  std::array<uint8_t, kCapacity> bytes_;
  size_t size_ = 0;
};

/// Decodes such a datagram, whatever the order of its keys and the width of its integers; the stamp
/// stays unset. Empty for anything that is not exactly one well-formed frame.
std::optional<CanFrame> DecodeCanDatagram(std::span<const uint8_t> bytes);

}  // namespace eod
