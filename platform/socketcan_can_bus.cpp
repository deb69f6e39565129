#include "platform/socketcan_can_bus.h"

#include <cerrno>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include "platform/can_filter.h"
#include "platform/socketcan_frame.h"

namespace eod {
namespace {

FileDescriptor OpenRawSocket(const std::string& url) {
  FileDescriptor opened(::socket(AF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW));
  if (!opened.is_open()) {
    throw std::runtime_error(fmt::format(
        "{}: no SocketCAN (AF_CAN) in this kernel: {}; try 'modprobe can_raw', or use the "
        "embedded bus: --bus udp:239.74.163.2:43113",
        url, std::strerror(errno)));
  }
  return opened;
}

/// Asks the kernel about the interface; nothing if there is none of that name.
std::optional<ifreq> QueryInterface(int socket, unsigned long request, const std::string& name) {
  ifreq query{};
  name.copy(query.ifr_name, IFNAMSIZ - 1);
  if (::ioctl(socket, request, &query) < 0) return {};
  return query;
}

void RequireCanInterface(int socket, const std::string& url, const std::string& name) {
  const auto hardware = name.size() < IFNAMSIZ && !name.empty()
                            ? QueryInterface(socket, SIOCGIFHWADDR, name)
                            : std::nullopt;
  if (!hardware) {
    throw std::runtime_error(fmt::format(
        "{}: no interface '{}'; list them with 'ip link show type can' and 'type vcan', or "
        "make one: ip link add {} type vcan && ip link set {} up",
        url, name, "vcan0", "vcan0"));
  }
  if (hardware->ifr_hwaddr.sa_family != ARPHRD_CAN) {
    throw std::runtime_error(fmt::format(
        "{}: '{}' is not a CAN interface; list those with 'ip link show type can'", url, name));
  }
}

void SetRawOption(int socket, int option, int value) {
  ::setsockopt(socket, SOL_CAN_RAW, option, &value, sizeof value);
}

}  // namespace

SocketCanBus::SocketCanBus(const std::string& interface_name, const Clock& clock)
    : url_("socketcan:" + interface_name),
      interface_name_(interface_name),
      socket_(OpenRawSocket(url_)),
      receiver_(clock) {
  RequireCanInterface(socket_.get(), url_, interface_name_);
  receiver_.Configure(socket_.get());
  SetRawOption(socket_.get(), CAN_RAW_FD_FRAMES, 1);
  // Loopback itself stays on: the other programs of this host (candump) shall see what we send.
  SetRawOption(socket_.get(), CAN_RAW_RECV_OWN_MSGS, 0);
  Maintain(clock.Now());
  counters_.restarts = 0;
}

SendOutcome SocketCanBus::Send(const CanFrame& frame) {
  if (state_ == CanBusState::kUp && !frame.error && IsWellFormed(frame)) {
    const canfd_frame raw = ToSocketCan(frame);
    if (::send(socket_.get(), &raw, SocketCanSize(frame), MSG_DONTWAIT | MSG_NOSIGNAL) >= 0) {
      ++counters_.tx;
      return SendOutcome::kSent;
    }
    NoteSocketError(errno);
  }
  ++counters_.tx_dropped;
  return SendOutcome::kDropped;
}

std::optional<CanFrame> SocketCanBus::Receive() {
  for (;;) {
    const auto datagram = receiver_.Next(socket_.get());
    if (!datagram) {
      if (receiver_.error() != 0) NoteSocketError(receiver_.error());
      return {};
    }
    auto frame = FromSocketCan(datagram->bytes);
    if (!frame) {
      ++counters_.malformed;
    } else if (frame->error) {
      NoteErrorFrame(*frame);
    } else if (IsAccepted(filters_, *frame)) {
      ++counters_.rx;
      frame->stamp = datagram->stamp;
      return frame;
    }
  }
}

void SocketCanBus::Maintain(TimePoint /*now*/) {
  const auto index = QueryInterface(socket_.get(), SIOCGIFINDEX, interface_name_);
  const auto flags = QueryInterface(socket_.get(), SIOCGIFFLAGS, interface_name_);
  if (!index || !flags) {
    NoteSocketError(ENODEV);
    return;
  }
  // A number that changed is an interface that was deleted and made again.
  if (index->ifr_ifindex != bound_index_ && !Bind(index->ifr_ifindex)) return;
  const bool is_up = (flags->ifr_flags & IFF_UP) != 0;
  const bool has_carrier = (flags->ifr_flags & IFF_RUNNING) != 0;
  if (!is_up) {
    NoteSocketError(ENETDOWN);
  } else if (state_ == CanBusState::kDown) {
    Restart();
  } else if (state_ == CanBusState::kBusOff) {
    // Drivers drop the carrier during bus-off. Seen again, the controller has restarted, even if
    // the error frame that says so was lost.
    if (has_carrier && was_carrier_lost_) Restart();
    was_carrier_lost_ = !has_carrier;
  }
}

void SocketCanBus::SetFilters(std::span<const CanFilter> filters) {
  filters_.assign(filters.begin(), filters.end());
  ApplyFilters();
}

CanBusCounters SocketCanBus::counters() const {
  CanBusCounters counters = counters_;
  counters.rx_lost = receiver_.lost();
  return counters;
}

void SocketCanBus::ApplyFilters() {
  std::vector<can_filter> raw;
  for (const CanFilter& filter : filters_) {
    raw.push_back({.can_id = filter.id | (filter.extended ? CAN_EFF_FLAG : 0),
                   .can_mask = filter.mask | CAN_EFF_FLAG});
  }
  // More than the kernel takes: it passes everything and Receive filters.
  if (raw.empty() || raw.size() > CAN_RAW_FILTER_MAX) raw.assign(1, can_filter{0, 0});
  ::setsockopt(socket_.get(), SOL_CAN_RAW, CAN_RAW_FILTER, raw.data(),
               static_cast<socklen_t>(raw.size() * sizeof raw[0]));
}

bool SocketCanBus::Bind(int interface_index) {
  // The kernel forgets a socket's filters together with its interface.
  ApplyFilters();
  SetRawOption(socket_.get(), CAN_RAW_ERR_FILTER, CAN_ERR_MASK);
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = interface_index;
  if (::bind(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) < 0) {
    NoteSocketError(errno);
    return false;
  }
  state_ = CanBusState::kDown;
  bound_index_ = interface_index;
  return true;
}

void SocketCanBus::NoteSocketError(int error) {
  switch (error) {
    case ENODEV:
    case ENXIO:
      bound_index_ = 0;
      state_ = CanBusState::kDown;
      break;
    case ENETDOWN:
      state_ = CanBusState::kDown;
      break;
    default:  // no buffer, or nothing that this interface can carry: this one frame is lost
      break;
  }
}

void SocketCanBus::NoteErrorFrame(const CanFrame& frame) {
  ++counters_.error_frames;
  const bool is_active_again =
      (frame.id & CAN_ERR_CRTL) != 0 && (frame.data[1] & CAN_ERR_CRTL_ACTIVE) != 0;
  if ((frame.id & CAN_ERR_BUSOFF) != 0) {
    state_ = CanBusState::kBusOff;
    was_carrier_lost_ = false;
  } else if (state_ == CanBusState::kBusOff &&
             ((frame.id & CAN_ERR_RESTARTED) != 0 || is_active_again)) {
    Restart();
  }
}

void SocketCanBus::Restart() {
  // An error that the socket still holds is about the outage that just ended.
  int past_error = 0;
  socklen_t size = sizeof past_error;
  ::getsockopt(socket_.get(), SOL_SOCKET, SO_ERROR, &past_error, &size);
  state_ = CanBusState::kUp;
  ++counters_.restarts;
}

}  // namespace eod
