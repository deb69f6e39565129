#include "platform/lcm_station.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include "platform/file_descriptor.h"
#include "platform/multicast.h"

namespace eod {
namespace {

constexpr std::string_view kDefaultUrl = "udpm://239.255.76.67:7667?ttl=0";
constexpr std::string_view kUdpScheme = "udpm://";
// With the system's default, a picture of 1 MB never arrives whole.
constexpr int kReceiveBytes = 4'000'000;

std::string ChooseUrl(const LcmStation& station) {
  if (!station.url.empty()) return station.url;
  const char* from_environment = std::getenv("LCM_DEFAULT_URL");
  const bool is_set = from_environment != nullptr && *from_environment != '\0';
  return std::string(is_set ? std::string_view(from_environment) : kDefaultUrl);
}

/// What the system grants of kReceiveBytes. LCM prints a warning if it is given less than it asked.
int GrantedReceiveBytes() {
  const FileDescriptor probe(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  ::setsockopt(probe.get(), SOL_SOCKET, SO_RCVBUF, &kReceiveBytes, sizeof kReceiveBytes);
  int granted = 0;
  socklen_t size = sizeof granted;
  ::getsockopt(probe.get(), SOL_SOCKET, SO_RCVBUF, &granted, &size);
  return std::min(granted, kReceiveBytes);
}

std::string WithReceiveBuffer(const std::string& url) {
  if (url.find("recv_buf_size=") != std::string::npos) return url;
  const char separator = url.find('?') == std::string::npos ? '?' : '&';
  return fmt::format("{}{}recv_buf_size={}", url, separator, GrantedReceiveBytes());
}

/// The group and port that a udpm URL writes, or LCM's own where it leaves them out.
std::optional<sockaddr_in> ParseUdpUrl(std::string_view url) {
  url.remove_prefix(kUdpScheme.size());
  const std::string_view address = url.substr(0, url.find('?'));
  const size_t colon = address.find(':');
  const std::string_view host = address.substr(0, colon);
  int port = 7667;
  if (colon != std::string_view::npos) {
    const char* end = address.data() + address.size();
    const auto [stop, error] = std::from_chars(address.data() + colon + 1, end, port);
    if (error != std::errc{} || stop != end || port < 1) return {};
  }
  const auto group = ParseIpv4(host.empty() ? "239.255.76.67" : std::string(host), port);
  if (!group || !IsMulticast(*group)) return {};
  return group;
}

void RequireUdpGroup(const std::string& url) {
  const auto group = ParseUdpUrl(url);
  if (!group) {
    throw std::runtime_error(
        fmt::format("{}: no IPv4 multicast group and port, such as {}", url, kDefaultUrl));
  }
  RequireMulticastRoute(url, *group);
}

/// LCM would report a log that it cannot read in words of its own, before us.
void RequireReadableLog(const std::string& url) {
  constexpr std::string_view kFileScheme = "file://";
  if (!url.starts_with(kFileScheme) || url.find("mode=w") != std::string::npos) return;
  const std::string file = url.substr(kFileScheme.size(), url.find('?') - kFileScheme.size());
  if (::access(file.c_str(), R_OK) != 0) {
    throw std::runtime_error(fmt::format("{}: {}: {}", url, file, std::strerror(errno)));
  }
}

}  // namespace

bool IsChannelPrefix(std::string_view prefix) {
  return prefix.size() <= 32 && std::ranges::all_of(prefix, [](char c) {
           return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ||
                  c == '_';
         });
}

std::unique_ptr<lcm::LCM> OpenLcm(const LcmStation& station) {
  if (!IsChannelPrefix(station.channel_prefix)) {
    throw std::runtime_error(fmt::format(
        "channel prefix '{}': allowed are up to 32 of A-Z a-z 0-9 _", station.channel_prefix));
  }
  std::string url = ChooseUrl(station);
  const bool is_known =
      url.starts_with(kUdpScheme) || url.starts_with("memq://") || url.starts_with("file://");
  if (!is_known) {
    throw std::runtime_error(
        fmt::format("'{}' names no LCM network; allowed are udpm://GROUP:PORT?ttl=N, memq:// and "
                    "file://LOG?mode=r",
                    url));
  }
  RequireReadableLog(url);
  if (url.starts_with(kUdpScheme)) {
    RequireUdpGroup(url);
    url = WithReceiveBuffer(url);
  }
  auto opened = std::make_unique<lcm::LCM>(url);
  if (!opened->good()) throw std::runtime_error(fmt::format("{}: LCM cannot open it", url));
  return opened;
}

}  // namespace eod
