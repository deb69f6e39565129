#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <sys/socket.h>

#include "platform/clock.h"

namespace eod {

/// One datagram of a socket, as the kernel handed it out.
struct Datagram {
  std::span<const uint8_t> bytes;  ///< valid until the next call of `Next`
  bool truncated = false;          ///< longer than the receiver's buffer
  int flags = 0;                   ///< MSG_* of recvmsg
  sockaddr_storage source{};
  TimePoint stamp{};  ///< arrival in the kernel, on the product's time base
};

/// Reads datagrams from a non-blocking socket in bursts (recvmmsg), with the kernel's time stamps
/// and its count of datagrams lost to a full queue.
class DatagramReceiver {
 public:
  /// `clock` must outlive the receiver.
  explicit DatagramReceiver(const Clock& clock);
  DatagramReceiver(const DatagramReceiver&) = delete;
  DatagramReceiver& operator=(const DatagramReceiver&) = delete;

  /// Asks the kernel for stamps, for the loss count (SO_RXQ_OVFL) and for a receive queue as long
  /// as this process may have. Throws std::system_error.
  void Configure(int socket);

  /// Next waiting datagram, or nothing: the queue is empty, or `error` tells why not.
  std::optional<Datagram> Next(int socket);

  /// errno of the last `Next` that returned nothing; 0 if the queue was just empty.
  int error() const { return error_; }

  /// Datagrams that the socket's queue had no room for, since Configure.
  uint64_t lost() const { return lost_; }

 private:
  static constexpr size_t kBurst = 16;
  static constexpr size_t kBytes = 512;  ///< over any frame: 72 in SocketCAN, 280 in msgpack
  static constexpr size_t kControlBytes = 128;
  struct Slot {
    std::array<uint8_t, kBytes> bytes;
    alignas(cmsghdr) std::array<uint8_t, kControlBytes> control;
    sockaddr_storage source;
    iovec vector;
  };

  bool Refill(int socket);
  void ReadControl(msghdr& header, Datagram& datagram);
  TimePoint ToProductTime(const timespec& kernel_stamp) const;

  const Clock& clock_;
  std::array<Slot, kBurst> slots_{};
  std::array<mmsghdr, kBurst> headers_{};
  size_t next_ = 0;
  size_t filled_ = 0;
  int error_ = 0;
  uint32_t kernel_lost_ = 0;
  uint64_t lost_ = 0;
};

}  // namespace eod
