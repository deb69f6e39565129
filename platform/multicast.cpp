#include "platform/multicast.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <arpa/inet.h>
#include <fmt/format.h>
#include <sys/socket.h>

#include "platform/file_descriptor.h"

namespace eod {

std::optional<sockaddr_in> ParseIpv4(const std::string& text, int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  if (port < 0 || port > 65535 || ::inet_pton(AF_INET, text.c_str(), &address.sin_addr) != 1) {
    return {};
  }
  return address;
}

bool IsMulticast(const sockaddr_in& address) {
  return IN_MULTICAST(ntohl(address.sin_addr.s_addr));
}

void RequireMulticastRoute(const std::string& url, const sockaddr_in& group) {
  const FileDescriptor probe(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  const ip_mreqn membership{
      .imr_multiaddr = group.sin_addr, .imr_address = {INADDR_ANY}, .imr_ifindex = 0};
  // Connecting looks the way out up, joining the way in; neither sends anything.
  if (::connect(probe.get(), reinterpret_cast<const sockaddr*>(&group), sizeof group) < 0 ||
      ::setsockopt(probe.get(), IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof membership) <
          0) {
    throw std::runtime_error(
        fmt::format("{}: no multicast route ({}); for one host run: "
                    "ip link set lo up && ip route add 224.0.0.0/4 dev lo",
                    url, std::strerror(errno)));
  }
}

}  // namespace eod
