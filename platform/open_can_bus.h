#pragma once

#include <memory>
#include <string>

#include "platform/can_bus.h"
#include "platform/clock.h"

namespace eod {

struct CanBusOptions {
  int multicast_ttl = 0;  ///< udp only: 0 stays on this host, 1 reaches the local network
};

/// Opens the bus that `url` names: `socketcan:IFACE`, `udp:GROUP:PORT` or `inproc:NAME`.
///
/// `clock` stamps frames where the transport does not; it must outlive the bus. An in-process bus
/// is shared by name within the process. Throws std::runtime_error with one line that names the
/// URL, what is wrong and what to do: unknown scheme, no AF_CAN in this kernel, no such interface,
/// port in use, no multicast route.
std::unique_ptr<CanBus> OpenCanBus(const std::string& url, const Clock& clock,
                                   const CanBusOptions& options = {});

}  // namespace eod
