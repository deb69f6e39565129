#pragma once

#include <chrono>
#include <cstdlib>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <poll.h>

#include "platform/can_bus.h"
#include "platform/clock.h"
#include "platform/open_can_bus.h"

namespace eod {

/// A form of the bus that the contract is tested on.
struct Medium {
  std::string name;
  std::string url;

  friend std::ostream& operator<<(std::ostream& out, const Medium& medium) {
    return out << medium.url;
  }
};

/// The interface of this kernel that tests may use, from EOD_TEST_SOCKETCAN; empty if there is
/// none.
inline std::string SocketCanInterface() {
  const char* name = std::getenv("EOD_TEST_SOCKETCAN");
  return name == nullptr ? "" : name;
}

inline std::vector<Medium> Mediums() {
  std::vector<Medium> mediums{{"Inproc", "inproc:contract"}, {"Udp", "udp:239.74.163.2:43113"}};
  if (const std::string name = SocketCanInterface(); !name.empty()) {
    mediums.push_back({"SocketCan", "socketcan:" + name});
  }
  return mediums;
}

/// Next frame, waited for as long as a test may last; empty if none ever comes.
inline std::optional<CanFrame> Await(CanBus& bus) {
  for (;;) {
    if (const auto frame = bus.Receive()) return frame;
    pollfd entry{.fd = bus.PollDescriptor(), .events = POLLIN, .revents = 0};
    if (entry.fd < 0 || ::poll(&entry, 1, 5000) <= 0) return {};
  }
}

}  // namespace eod
