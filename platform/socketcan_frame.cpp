#include "platform/socketcan_frame.h"

#include <algorithm>
#include <cstring>

namespace eod {

canfd_frame ToSocketCan(const CanFrame& frame) {
  canfd_frame raw{};
  raw.can_id = frame.id | (frame.extended ? CAN_EFF_FLAG : 0) | (frame.remote ? CAN_RTR_FLAG : 0) |
               (frame.error ? CAN_ERR_FLAG : 0);
  raw.len = frame.length;
  raw.flags = static_cast<uint8_t>((frame.bit_rate_switch ? CANFD_BRS : 0) |
                                   (frame.error_state_indicator ? CANFD_ESI : 0));
  std::ranges::copy(frame.payload(), raw.data);
  return raw;
}

size_t SocketCanSize(const CanFrame& frame) { return frame.fd ? CANFD_MTU : CAN_MTU; }

std::optional<CanFrame> FromSocketCan(std::span<const uint8_t> bytes) {
  if (bytes.size() != CAN_MTU && bytes.size() != CANFD_MTU) return {};
  canfd_frame raw{};
  std::memcpy(&raw, bytes.data(), bytes.size());
  CanFrame frame;
  frame.error = (raw.can_id & CAN_ERR_FLAG) != 0;
  frame.extended = !frame.error && (raw.can_id & CAN_EFF_FLAG) != 0;
  frame.remote = !frame.error && (raw.can_id & CAN_RTR_FLAG) != 0;
  frame.id = raw.can_id & (frame.error || frame.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
  frame.fd = bytes.size() == CANFD_MTU;
  frame.bit_rate_switch = frame.fd && (raw.flags & CANFD_BRS) != 0;
  frame.error_state_indicator = frame.fd && (raw.flags & CANFD_ESI) != 0;
  frame.length = std::min<uint8_t>(raw.len, frame.fd ? CANFD_MAX_DLEN : CAN_MAX_DLEN);
  std::ranges::copy_n(raw.data, static_cast<std::ptrdiff_t>(frame.payload().size()),
                      frame.data.begin());
  if (!IsWellFormed(frame)) return {};
  return frame;
}

}  // namespace eod
