#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <linux/can.h>

#include "platform/can_frame.h"

namespace eod {

/// `frame` as SocketCAN's sockets take it.
canfd_frame ToSocketCan(const CanFrame& frame);

/// Bytes of it that are written: 16 for a classic frame, 72 for CAN FD.
size_t SocketCanSize(const CanFrame& frame);

/// Inverse of ToSocketCan; the stamp stays unset. Empty if `bytes` are no frame.
std::optional<CanFrame> FromSocketCan(std::span<const uint8_t> bytes);

}  // namespace eod
