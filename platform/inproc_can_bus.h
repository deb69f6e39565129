#pragma once

#include <memory>
#include <string>

#include "platform/can_bus.h"
#include "platform/clock.h"

namespace eod {

/// An in-process CAN bus, for lock-step and tests: what a node sends waits at every other node at
/// once, in the order of sending. Everything happens in the one thread that uses it.
class InprocCanHub {
 public:
  /// Nodes of the bus report the URL `inproc:NAME`.
  explicit InprocCanHub(std::string name = "hub");

  /// Connects one more node, until it is destroyed; the hub may go before its nodes. Frames that it
  /// sends are stamped by `clock`, which must outlive it.
  std::unique_ptr<CanBus> Connect(const Clock& clock);

  /// Lets the bus fail or return: unless it is up, every node's frames are dropped and counted.
  void SetState(CanBusState state);

  class Wire;

 private:
  std::shared_ptr<Wire> wire_;
};

/// Frames that wait at most at one node; further ones are lost and counted in `rx_lost`.
inline constexpr size_t kInprocQueueLength = 4096;

/// Connects to the bus that all callers of this process with the same name share.
std::unique_ptr<CanBus> OpenInprocCanBus(const std::string& name, const Clock& clock);

}  // namespace eod
