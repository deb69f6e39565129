#pragma once

#include <optional>
#include <string>

#include <netinet/in.h>

namespace eod {

/// IPv4 address that `text` writes in dotted form, with `port` (0..65535).
std::optional<sockaddr_in> ParseIpv4(const std::string& text, int port);

/// True for 224.0.0.0 to 239.255.255.255.
bool IsMulticast(const sockaddr_in& address);

/// Throws std::runtime_error with one line that begins with `url` and names the remedy if no route
/// of this system leads to `group`.
void RequireMulticastRoute(const std::string& url, const sockaddr_in& group);

}  // namespace eod
