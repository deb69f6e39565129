#include "platform/datagram_receiver.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <system_error>

namespace eod {
namespace {

constexpr int kQueueBytes = 4 << 20;

// A stamp further back than this is not a wait in the queue but a wall clock that was set.
constexpr Duration kOldestStamp = std::chrono::seconds(10);

Duration FromTimespec(const timespec& time) {
  return std::chrono::seconds{time.tv_sec} + std::chrono::nanoseconds{time.tv_nsec};
}

}  // namespace

DatagramReceiver::DatagramReceiver(const Clock& clock) : clock_(clock) {
  for (size_t i = 0; i < kBurst; ++i) {
    Slot& slot = slots_[i];
    slot.vector = {.iov_base = slot.bytes.data(), .iov_len = slot.bytes.size()};
    msghdr& header = headers_[i].msg_hdr;
    header.msg_name = &slot.source;
    header.msg_iov = &slot.vector;
    header.msg_iovlen = 1;
    header.msg_control = slot.control.data();
  }
}

void DatagramReceiver::Configure(int socket) {
  const int on = 1;
  for (const int option : {SO_TIMESTAMPNS, SO_RXQ_OVFL}) {
    if (::setsockopt(socket, SOL_SOCKET, option, &on, sizeof on) < 0) {
      throw std::system_error(errno, std::generic_category(), "setsockopt");
    }
  }
  // Past the system's limit only with privilege; otherwise the kernel gives what is allowed.
  if (::setsockopt(socket, SOL_SOCKET, SO_RCVBUFFORCE, &kQueueBytes, sizeof kQueueBytes) < 0) {
    ::setsockopt(socket, SOL_SOCKET, SO_RCVBUF, &kQueueBytes, sizeof kQueueBytes);
  }
}

std::optional<Datagram> DatagramReceiver::Next(int socket) {
  if (next_ == filled_ && !Refill(socket)) return {};
  Slot& slot = slots_[next_];
  mmsghdr& received = headers_[next_];
  ++next_;
  Datagram datagram{
      .bytes = std::span(slot.bytes).first(std::min<size_t>(received.msg_len, kBytes)),
      .truncated = (received.msg_hdr.msg_flags & MSG_TRUNC) != 0,
      .flags = received.msg_hdr.msg_flags,
      .source = slot.source,
      .stamp = {}};
  ReadControl(received.msg_hdr, datagram);
  return datagram;
}

bool DatagramReceiver::Refill(int socket) {
  for (mmsghdr& header : headers_) {
    header.msg_hdr.msg_namelen = sizeof(sockaddr_storage);
    header.msg_hdr.msg_controllen = kControlBytes;
  }
  const int count = ::recvmmsg(socket, headers_.data(), kBurst, MSG_DONTWAIT, nullptr);
  error_ = count < 0 && errno != EAGAIN && errno != EINTR ? errno : 0;
  next_ = 0;
  filled_ = static_cast<size_t>(std::max(count, 0));
  return filled_ > 0;
}

void DatagramReceiver::ReadControl(msghdr& header, Datagram& datagram) {
  datagram.stamp = clock_.Now();
  for (cmsghdr* item = CMSG_FIRSTHDR(&header); item != nullptr; item = CMSG_NXTHDR(&header, item)) {
    if (item->cmsg_level != SOL_SOCKET) continue;
    if (item->cmsg_type == SCM_TIMESTAMPNS) {
      timespec kernel_stamp{};
      std::memcpy(&kernel_stamp, CMSG_DATA(item), sizeof kernel_stamp);
      datagram.stamp = ToProductTime(kernel_stamp);
    } else if (item->cmsg_type == SO_RXQ_OVFL) {
      uint32_t total = 0;
      std::memcpy(&total, CMSG_DATA(item), sizeof total);
      lost_ += total - kernel_lost_;  // modulo 2^32, as the kernel counts
      kernel_lost_ = total;
    }
  }
}

TimePoint DatagramReceiver::ToProductTime(const timespec& kernel_stamp) const {
  // The kernel stamps by the wall clock, which may step; only the age of the stamp is used.
  timespec wall_now{};
  ::clock_gettime(CLOCK_REALTIME, &wall_now);
  const TimePoint now = clock_.Now();
  const Duration age = FromTimespec(wall_now) - FromTimespec(kernel_stamp);
  return age >= Duration::zero() && age <= kOldestStamp ? now - age : now;
}

}  // namespace eod
