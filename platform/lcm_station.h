#pragma once

#include <memory>
#include <string>
#include <string_view>

#include <lcm/lcm-cpp.hpp>

namespace eod {

/// Where a program meets the others: `--lcm-url`, `--channel-prefix`.
struct LcmStation {
  /// Empty: LCM_DEFAULT_URL, or else udpm://239.255.76.67:7667?ttl=0. A udpm URL that does not set
  /// its receive buffer gets as much of 4 MB as the system grants.
  std::string url;
  /// Put before every channel name; tells several stations on one network apart.
  std::string channel_prefix;
};

/// True for up to 32 of A-Z a-z 0-9 _: channel names stay legal and within LCM's 63 characters.
bool IsChannelPrefix(std::string_view prefix);

/// Opens LCM. Throws std::runtime_error with one line that names the URL and the remedy: a
/// malformed URL, or no multicast route ("ip route add 224.0.0.0/4 dev lo").
std::unique_ptr<lcm::LCM> OpenLcm(const LcmStation& station);

}  // namespace eod
