#pragma once

#include <string>

namespace eod::console {

struct ConsoleConfig {
  std::string channel_prefix;
  std::string address = "127.0.0.1";  ///< IPv4 that browsers come to
  int port = 8080;                    ///< 0: any free one
};

/// For people: what would be shown where, and from which channels.
std::string Describe(const ConsoleConfig& config);

}  // namespace eod::console
