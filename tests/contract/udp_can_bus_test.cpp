#include <cstdlib>
#include <stdexcept>

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include "platform/can_datagram.h"
#include "platform/file_descriptor.h"
#include "platform/multicast.h"
#include "tests/contract/can_bus_medium.h"

namespace eod {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr int kPort = 43113;
constexpr const char* kGroup = "239.74.163.2";
constexpr CanFrame kMarker{.id = 0x7FF, .length = 1, .data = {0xEE}};

/// A stranger on the network, who may send anything anywhere.
class Stranger {
 public:
  void Send(std::span<const uint8_t> bytes, const std::string& group = kGroup) {
    const sockaddr_in to = *ParseIpv4(group, kPort);
    ASSERT_EQ(::sendto(socket_.get(), bytes.data(), bytes.size(), 0,
                       reinterpret_cast<const sockaddr*>(&to), sizeof to),
              static_cast<ssize_t>(bytes.size()));
  }

 private:
  FileDescriptor socket_{::socket(AF_INET, SOCK_DGRAM, 0)};
};

class UdpCanBusTest : public testing::Test {
 protected:
  SteadyClock clock_;
  std::unique_ptr<CanBus> dut_ = OpenCanBus("udp:239.74.163.2:43113", clock_);
  Stranger stranger_;
};

TEST_F(UdpCanBusTest, CountsMalformedDatagramsAndGoesOn) {
  const std::vector<uint8_t> too_long(2000, 0x80);
  const std::vector<uint8_t> truncated(100, 0x8b);
  stranger_.Send({});
  stranger_.Send(too_long);
  stranger_.Send(truncated);
  const CanDatagram good(kMarker, clock_.Now());
  stranger_.Send(good.bytes().first(good.bytes().size() - 1));
  stranger_.Send(good.bytes());
  const auto received = Await(*dut_);
  ASSERT_TRUE(received.has_value());
  EXPECT_TRUE(SameOnWire(*received, kMarker));
  EXPECT_EQ(dut_->counters().malformed, 4U);
  EXPECT_EQ(dut_->counters().rx, 1U);
}

TEST_F(UdpCanBusTest, CountsErrorFramesAndDoesNotReturnThem) {
  stranger_.Send(CanDatagram({.id = 0x40, .error = true, .length = 8}, clock_.Now()).bytes());
  stranger_.Send(CanDatagram(kMarker, clock_.Now()).bytes());
  EXPECT_TRUE(SameOnWire(*Await(*dut_), kMarker));
  EXPECT_EQ(dut_->counters().error_frames, 1U);
  EXPECT_EQ(dut_->counters().rx, 1U);
}

TEST_F(UdpCanBusTest, DoesNotHearAnotherGroupOfItsPort) {
  const auto other = OpenCanBus("udp:239.74.163.3:43113", clock_);
  stranger_.Send(CanDatagram({.id = 1}, clock_.Now()).bytes(), "239.74.163.3");
  ASSERT_EQ(Await(*other)->id, 1U);
  stranger_.Send(CanDatagram(kMarker, clock_.Now()).bytes());
  EXPECT_TRUE(SameOnWire(*Await(*dut_), kMarker)) << "the other group's frame came first";
}

TEST_F(UdpCanBusTest, StaysOnThisHostUnlessTold) {
  // The time to live arrives with the datagram: 0 from a bus with the default options.
  const FileDescriptor listener(::socket(AF_INET, SOCK_DGRAM, 0));
  const int on = 1;
  ::setsockopt(listener.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  ::setsockopt(listener.get(), IPPROTO_IP, IP_RECVTTL, &on, sizeof on);
  const sockaddr_in group = *ParseIpv4(kGroup, kPort);
  ASSERT_EQ(::bind(listener.get(), reinterpret_cast<const sockaddr*>(&group), sizeof group), 0);
  const auto ttl_of_next = [&listener] {
    std::array<char, 512> bytes{};
    alignas(cmsghdr) std::array<char, 64> control{};
    iovec vector{.iov_base = bytes.data(), .iov_len = bytes.size()};
    msghdr header{};
    header.msg_iov = &vector;
    header.msg_iovlen = 1;
    header.msg_control = control.data();
    header.msg_controllen = control.size();
    EXPECT_GT(::recvmsg(listener.get(), &header, 0), 0);
    const cmsghdr* const first = CMSG_FIRSTHDR(&header);
    return first == nullptr ? -1 : *reinterpret_cast<const int*>(CMSG_DATA(first));
  };
  dut_->Send(kMarker);
  EXPECT_EQ(ttl_of_next(), 0);
  OpenCanBus("udp:239.74.163.2:43113", clock_, {.multicast_ttl = 3})->Send(kMarker);
  EXPECT_EQ(ttl_of_next(), 3);
}

TEST_F(UdpCanBusTest, KnowsItsOwnFramesWhenTheHostsAddressChanges) {
  // The loopback's 127.0.0.1 is the source only as long as there is no address of wider scope.
  ASSERT_EQ(std::system("ip addr add 192.0.2.9/32 dev lo"), 0);
  dut_->Maintain(clock_.Now());
  dut_->Send({.id = 1});
  stranger_.Send(CanDatagram(kMarker, clock_.Now()).bytes());
  const auto received = Await(*dut_);
  ASSERT_EQ(std::system("ip addr del 192.0.2.9/32 dev lo"), 0);
  ASSERT_TRUE(received.has_value());
  EXPECT_EQ(received->id, kMarker.id);
}

TEST_F(UdpCanBusTest, NamesAPortThatAnotherProgramKeepsForItself) {
  const FileDescriptor taken(::socket(AF_INET, SOCK_DGRAM, 0));
  const sockaddr_in any = *ParseIpv4("0.0.0.0", 43999);
  ASSERT_EQ(::bind(taken.get(), reinterpret_cast<const sockaddr*>(&any), sizeof any), 0);
  EXPECT_THAT([this] { OpenCanBus("udp:239.74.163.2:43999", clock_); },
              ThrowsMessage<std::runtime_error>(
                  AllOf(HasSubstr("udp:239.74.163.2:43999: Address already in use"),
                        HasSubstr("use another port"))));
}

}  // namespace
}  // namespace eod
