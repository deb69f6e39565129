#include "platform/udp_can_bus.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <sys/socket.h>

#include "platform/can_datagram.h"
#include "platform/can_filter.h"
#include "platform/multicast.h"

namespace eod {
namespace {

const sockaddr* AsSocketAddress(const sockaddr_in& address) {
  return reinterpret_cast<const sockaddr*>(&address);
}

FileDescriptor OpenUdpSocket(const std::string& url) {
  FileDescriptor opened(::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!opened.is_open()) {
    throw std::runtime_error(fmt::format("{}: no socket: {}", url, std::strerror(errno)));
  }
  return opened;
}

void SetOption(const FileDescriptor& socket, int level, int option, int value) {
  ::setsockopt(socket.get(), level, option, &value, sizeof value);
}

}  // namespace

UdpCanBus::UdpCanBus(std::string url, const sockaddr_in& group, int ttl, const Clock& clock)
    : url_(std::move(url)), clock_(clock), receiver_(clock) {
  RequireMulticastRoute(url_, group);
  OpenSendSocket(group, ttl);
  OpenReceiveSocket(group);
}

void UdpCanBus::OpenReceiveSocket(const sockaddr_in& group) {
  receive_socket_ = OpenUdpSocket(url_);
  // Several programs of a host share the port. Bound to the group, and with IP_MULTICAST_ALL off,
  // the socket hears this bus alone, whatever else the host has joined.
  SetOption(receive_socket_, SOL_SOCKET, SO_REUSEADDR, 1);
  SetOption(receive_socket_, IPPROTO_IP, IP_MULTICAST_ALL, 0);
  if (::bind(receive_socket_.get(), AsSocketAddress(group), sizeof group) < 0) {
    const bool is_in_use = errno == EADDRINUSE;
    throw std::runtime_error(fmt::format(
        "{}: {}; {}", url_, std::strerror(errno),
        is_in_use
            ? "another program keeps the port for itself: end it (ss -ulpn) or use another port"
            : "use a port that this user may open"));
  }
  const ip_mreqn membership{
      .imr_multiaddr = group.sin_addr, .imr_address = {INADDR_ANY}, .imr_ifindex = 0};
  if (::setsockopt(receive_socket_.get(), IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership,
                   sizeof membership) < 0) {
    throw std::runtime_error(
        fmt::format("{}: cannot join the group: {}", url_, std::strerror(errno)));
  }
  receiver_.Configure(receive_socket_.get());
}

void UdpCanBus::OpenSendSocket(const sockaddr_in& group, int ttl) {
  group_ = group;
  send_socket_ = OpenUdpSocket(url_);
  SetOption(send_socket_, IPPROTO_IP, IP_MULTICAST_TTL, ttl);
  sockaddr_in any{};
  any.sin_family = AF_INET;
  socklen_t size = sizeof own_address_;
  if (::bind(send_socket_.get(), AsSocketAddress(any), sizeof any) < 0 ||
      ::getsockname(send_socket_.get(), reinterpret_cast<sockaddr*>(&own_address_), &size) < 0) {
    throw std::runtime_error(fmt::format("{}: cannot send there: {}", url_, std::strerror(errno)));
  }
  FindOwnAddress();
}

void UdpCanBus::FindOwnAddress() {
  // Connecting tells the address that datagrams will come from. The socket that sends must not be
  // connected itself: a multicast with a fixed source leaves by the interface of that address,
  // whatever the route says, and misses who listens on the route's.
  const FileDescriptor probe(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  sockaddr_in source{};
  socklen_t size = sizeof source;
  if (::connect(probe.get(), AsSocketAddress(group_), sizeof group_) == 0 &&
      ::getsockname(probe.get(), reinterpret_cast<sockaddr*>(&source), &size) == 0) {
    own_address_.sin_addr = source.sin_addr;
  }
}

SendOutcome UdpCanBus::Send(const CanFrame& frame) {
  if (!frame.error && IsWellFormed(frame)) {
    const CanDatagram datagram(frame, clock_.Now());
    const auto bytes = datagram.bytes();
    if (::sendto(send_socket_.get(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL,
                 AsSocketAddress(group_), sizeof group_) >= 0) {
      ++counters_.tx;
      return SendOutcome::kSent;
    }
  }
  ++counters_.tx_dropped;
  return SendOutcome::kDropped;
}

std::optional<CanFrame> UdpCanBus::Receive() {
  while (const auto datagram = receiver_.Next(receive_socket_.get())) {
    if (IsOwn(*datagram)) continue;
    auto frame = datagram->truncated ? std::nullopt : DecodeCanDatagram(datagram->bytes);
    if (!frame) {
      ++counters_.malformed;
    } else if (frame->error) {
      ++counters_.error_frames;
    } else if (IsAccepted(filters_, *frame)) {
      ++counters_.rx;
      frame->stamp = datagram->stamp;
      return frame;
    }
  }
  return {};
}

bool UdpCanBus::IsOwn(const Datagram& datagram) const {
  const auto& source = reinterpret_cast<const sockaddr_in&>(datagram.source);
  return source.sin_port == own_address_.sin_port &&
         source.sin_addr.s_addr == own_address_.sin_addr.s_addr;
}

void UdpCanBus::SetFilters(std::span<const CanFilter> filters) {
  filters_.assign(filters.begin(), filters.end());
}

CanBusCounters UdpCanBus::counters() const {
  CanBusCounters counters = counters_;
  counters.rx_lost = receiver_.lost();
  return counters;
}

}  // namespace eod
