#pragma once

#include <string>
#include <vector>

#include "platform/can_bus.h"
#include "platform/clock.h"
#include "platform/datagram_receiver.h"
#include "platform/file_descriptor.h"

namespace eod {

/// A CAN interface of the Linux kernel (SocketCAN): a real adapter such as `can0`, or `vcan0`.
///
/// Survives that its interface is taken down, deleted and made again: the bus is then `kDown`,
/// drops what is sent, and `Maintain` binds the same descriptor once the interface is there again.
/// A controller that reports bus-off makes the bus `kBusOff` until it reports its restart (by
/// itself with `restart-ms`, or by `ip link set IFACE type can restart`) or is taken down and up.
class SocketCanBus final : public CanBus {
 public:
  /// `clock` must outlive the bus. Throws std::runtime_error, one line that begins with the URL
  /// `socketcan:INTERFACE`: no AF_CAN in this kernel, no such interface, not a CAN interface.
  SocketCanBus(const std::string& interface_name, const Clock& clock);

  SendOutcome Send(const CanFrame& frame) override;
  std::optional<CanFrame> Receive() override;
  int PollDescriptor() const override { return socket_.get(); }
  void Maintain(TimePoint now) override;
  void SetFilters(std::span<const CanFilter> filters) override;
  CanBusState state() const override { return state_; }
  CanBusCounters counters() const override;
  const std::string& url() const override { return url_; }

 private:
  void ApplyFilters();
  bool Bind(int interface_index);
  void NoteSocketError(int error);
  void NoteErrorFrame(const CanFrame& frame);
  void Restart();

  std::string url_;
  std::string interface_name_;
  FileDescriptor socket_;
  DatagramReceiver receiver_;
  std::vector<CanFilter> filters_;
  CanBusState state_ = CanBusState::kDown;
  int bound_index_ = 0;            ///< kernel's number of the interface; 0: none
  bool was_carrier_lost_ = false;  ///< during the present bus-off
  CanBusCounters counters_;
};

}  // namespace eod
