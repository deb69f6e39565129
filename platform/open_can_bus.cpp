#include "platform/open_can_bus.h"

#include <charconv>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "platform/inproc_can_bus.h"
#include "platform/multicast.h"
#include "platform/socketcan_can_bus.h"
#include "platform/udp_can_bus.h"

namespace eod {
namespace {

/// `GROUP:PORT`, an IPv4 multicast group and a port of 1..65535.
std::optional<sockaddr_in> ParseGroupAndPort(const std::string& text) {
  const size_t colon = text.rfind(':');
  if (colon == std::string::npos) return {};
  int port = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + colon + 1, end, port);
  if (error != std::errc{} || stop != end || port < 1) return {};
  const auto group = ParseIpv4(text.substr(0, colon), port);
  if (!group || !IsMulticast(*group)) return {};
  return group;
}

}  // namespace

std::unique_ptr<CanBus> OpenCanBus(const std::string& url, const Clock& clock,
                                   const CanBusOptions& options) {
  const size_t colon = url.find(':');
  const std::string scheme = url.substr(0, colon);
  const std::string rest = colon == std::string::npos ? "" : url.substr(colon + 1);
  if (scheme == "socketcan" && !rest.empty()) return std::make_unique<SocketCanBus>(rest, clock);
  if (scheme == "inproc" && !rest.empty()) return OpenInprocCanBus(rest, clock);
  if (scheme == "udp") {
    const auto group = ParseGroupAndPort(rest);
    if (!group) {
      throw std::runtime_error(
          fmt::format("{}: no IPv4 multicast group and port, such as udp:239.74.163.2:43113", url));
    }
    return std::make_unique<UdpCanBus>(url, *group, options.multicast_ttl, clock);
  }
  throw std::runtime_error(fmt::format(
      "'{}' names no CAN bus; allowed are socketcan:IFACE (socketcan:can0), udp:GROUP:PORT "
      "(udp:239.74.163.2:43113) and inproc:NAME",
      url));
}

}  // namespace eod
