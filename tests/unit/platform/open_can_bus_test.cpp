#include "platform/open_can_bus.h"

#include <stdexcept>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eod {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

const ManualClock kClock;

auto Refuses(const testing::Matcher<std::string>& message) {
  return ThrowsMessage<std::runtime_error>(AllOf(message, Not(HasSubstr("\n"))));
}

TEST(OpenCanBus, NamesTheKindsOfBusWhenItKnowsNone) {
  for (const char* url : {"", "can0", "pcan:1", "socketcan:", "inproc:", ":x"}) {
    EXPECT_THAT([url] { OpenCanBus(url, kClock); },
                Refuses(AllOf(HasSubstr(fmt::format("'{}' names no CAN bus", url)),
                              HasSubstr("socketcan:can0"), HasSubstr("udp:239.74.163.2:43113"),
                              HasSubstr("inproc:NAME"))));
  }
}

TEST(OpenCanBus, ShowsWhatAUdpUrlLooksLike) {
  for (const char* url : {"udp:", "udp:239.74.163.2", "udp:239.74.163.2:", "udp:239.74.163.2:0",
                          "udp:239.74.163.2:65536", "udp:239.74.163.2:1x", "udp:127.0.0.1:43113",
                          "udp:ff15::1:43113"}) {
    EXPECT_THAT([url] { OpenCanBus(url, kClock); },
                Refuses(HasSubstr(std::string(url) + ": no IPv4 multicast group and port")));
  }
}

TEST(OpenCanBus, NamesAnInterfaceThatIsNotThere) {
  // Where the kernel has no SocketCAN at all, it says that and names the bus that works anyway.
  EXPECT_THAT([] { OpenCanBus("socketcan:nosuch0", kClock); },
              Refuses(AnyOf(AllOf(HasSubstr("socketcan:nosuch0: no interface 'nosuch0'"),
                                  HasSubstr("ip link add vcan0 type vcan")),
                            AllOf(HasSubstr("socketcan:nosuch0: no SocketCAN (AF_CAN)"),
                                  HasSubstr("--bus udp:239.74.163.2:43113")))));
}

}  // namespace
}  // namespace eod
