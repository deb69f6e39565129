#pragma once

#include <chrono>

#include <lcm/lcm-cpp.hpp>

#include "platform/can_bus.h"
#include "platform/clock.h"
#include "platform/event_loop.h"

namespace eod {

/// Runs `node` on real time until an end signal: the one event loop that all programs share.
///
/// `node` offers `OnCan()` (frames may wait on the bus), `OnTick(TimePoint scheduled)` and
/// `tick_period()`; it subscribes to `lcm` itself. A node that offers `is_finished()` ends the run
/// once that is true after a tick. `bus` may be null for programs without CAN.
/// Returns the number of missed ticks.
template <typename Node>
uint64_t RunNode(Node& node, CanBus* bus, lcm::LCM& lcm, const Clock& clock) {
  EventLoop loop(clock);
  if (bus != nullptr) {
    loop.AddDescriptor(bus->PollDescriptor(), [&node] { node.OnCan(); });
    loop.AddTimer(std::chrono::milliseconds(50), [bus](TimePoint now) { bus->Maintain(now); });
  }
  loop.AddDescriptor(lcm.getFileno(), [&lcm] { lcm.handle(); });
  loop.AddTimer(node.tick_period(), [&node, &loop](TimePoint scheduled) {
    node.OnTick(scheduled);
    if constexpr (requires { node.is_finished(); }) {
      if (node.is_finished()) loop.Stop();
    }
  });
  loop.Run();
  return loop.missed_ticks();
}

}  // namespace eod
