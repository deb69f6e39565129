#pragma once

#include <string>
#include <vector>

#include <netinet/in.h>

#include "platform/can_bus.h"
#include "platform/clock.h"
#include "platform/datagram_receiver.h"
#include "platform/file_descriptor.h"

namespace eod {

/// A CAN bus over IPv4 multicast, in the format of python-can's udp_multicast interface: every
/// program that joins the group and port is a node, and there is no server.
class UdpCanBus final : public CanBus {
 public:
  /// `ttl`: 0 keeps frames on this host, 1 on the local network. `clock` must outlive the bus.
  /// Throws std::runtime_error, one line that begins with `url`.
  UdpCanBus(std::string url, const sockaddr_in& group, int ttl, const Clock& clock);

  SendOutcome Send(const CanFrame& frame) override;
  std::optional<CanFrame> Receive() override;
  int PollDescriptor() const override { return receive_socket_.get(); }
  /// Follows the host when its address changes: by address and port a node knows its own frames.
  void Maintain(TimePoint /*now*/) override { FindOwnAddress(); }
  void SetFilters(std::span<const CanFilter> filters) override;
  CanBusState state() const override { return CanBusState::kUp; }
  CanBusCounters counters() const override;
  const std::string& url() const override { return url_; }

 private:
  void OpenReceiveSocket(const sockaddr_in& group);
  void OpenSendSocket(const sockaddr_in& group, int ttl);
  void FindOwnAddress();
  bool IsOwn(const Datagram& datagram) const;

  std::string url_;
  const Clock& clock_;
  FileDescriptor receive_socket_;
  FileDescriptor send_socket_;  ///< its own port tells this node's datagrams from all others
  sockaddr_in group_{};
  sockaddr_in own_address_{};
  DatagramReceiver receiver_;
  std::vector<CanFilter> filters_;
  CanBusCounters counters_;
};

}  // namespace eod
