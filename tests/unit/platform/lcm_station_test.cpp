#include "platform/lcm_station.h"

#include <cstdlib>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>

#include "platform/open_can_bus.h"

namespace eod {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr const char* kGroup = "udpm://239.255.76.67:7667?ttl=0";

class LcmStationTest : public testing::Test {
 protected:
  void SetUp() override { ::unsetenv("LCM_DEFAULT_URL"); }
  void TearDown() override { ::unsetenv("LCM_DEFAULT_URL"); }
};

/// Publishes on `out` and returns what arrives on `in`.
std::string Exchange(lcm::LCM& out, lcm::LCM& in, const std::string& sent) {
  std::string received;
  struct Listener {
    std::string& received;
    void Take(const lcm::ReceiveBuffer* buffer, const std::string& /*channel*/) {
      received.assign(static_cast<const char*>(buffer->data), buffer->data_size);
    }
  } listener{received};
  in.subscribe("TEST", &Listener::Take, &listener);
  out.publish("TEST", sent.data(), static_cast<unsigned>(sent.size()));
  in.handleTimeout(5000);
  return received;
}

TEST_F(LcmStationTest, MeetsItsPeersAtTheDefaultAddress) {
  const auto a = OpenLcm({});
  const auto b = OpenLcm({.url = kGroup, .channel_prefix = ""});
  EXPECT_EQ(Exchange(*a, *b, "hello"), "hello");
}

TEST_F(LcmStationTest, HonoursTheEnvironmentsUrl) {
  ::setenv("LCM_DEFAULT_URL", "udpm://239.255.76.68:7668?ttl=0", 1);
  const auto a = OpenLcm({});
  const auto b = OpenLcm({.url = "udpm://239.255.76.68:7668?ttl=0", .channel_prefix = ""});
  EXPECT_EQ(Exchange(*a, *b, "hello"), "hello");
}

TEST_F(LcmStationTest, CarriesAMessageOfSeveralDatagramsWhole) {
  const auto a = OpenLcm({});
  const auto b = OpenLcm({});
  const std::string picture(200'000, 'x');
  EXPECT_EQ(Exchange(*a, *b, picture), picture);
}

TEST_F(LcmStationTest, AsksForNoMoreBufferThanTheSystemGrants) {
  testing::internal::CaptureStderr();
  const auto dut = OpenLcm({});
  EXPECT_EQ(Exchange(*dut, *dut, "hello"), "hello");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "LCM warned";
}

TEST_F(LcmStationTest, OpensAQueueInMemory) {
  const auto dut = OpenLcm({.url = "memq://", .channel_prefix = ""});
  EXPECT_EQ(Exchange(*dut, *dut, "hello"), "hello");
}

TEST_F(LcmStationTest, RefusesABadUrlWithOneLine) {
  const auto open = [](const char* url) {
    return [url] { OpenLcm({.url = url, .channel_prefix = ""}); };
  };
  EXPECT_THAT(open("tcp://somewhere"), ThrowsMessage<std::runtime_error>(
                                           HasSubstr("'tcp://somewhere' names no LCM network")));
  for (const char* url : {"udpm://239.255.76.67:x", "udpm://127.0.0.1:7667", "udpm://nonsense"}) {
    EXPECT_THAT(open(url), ThrowsMessage<std::runtime_error>(
                               HasSubstr(std::string(url) + ": no IPv4 multicast group and port")));
  }
  EXPECT_THAT(open("file:///nowhere/run.lcmlog?mode=r"),
              ThrowsMessage<std::runtime_error>(
                  HasSubstr("/nowhere/run.lcmlog: No such file or directory")));
}

TEST_F(LcmStationTest, RefusesAPrefixThatChannelsCannotHave) {
  for (const std::string& prefix : {std::string("A B"), std::string("Ä"), std::string(33, 'A')}) {
    EXPECT_THAT(([&prefix] { OpenLcm({.url = "memq://", .channel_prefix = prefix}); }),
                ThrowsMessage<std::runtime_error>(HasSubstr("channel prefix '" + prefix + "'")));
  }
}

/// Runs `open` in a network namespace without any route and prints what it throws.
[[noreturn]] void ReportWithoutRoutes(const std::function<void()>& open) {
  if (::unshare(CLONE_NEWNET) != 0) std::exit(3);
  try {
    open();
  } catch (const std::runtime_error& error) {
    std::cerr << error.what() << '\n';
    std::exit(1);
  }
  std::exit(0);
}

TEST(MulticastRouteDeathTest, MissingForLcmIsOneLineWithTheRemedy) {
  EXPECT_EXIT(ReportWithoutRoutes([] { OpenLcm({.url = kGroup, .channel_prefix = ""}); }),
              testing::ExitedWithCode(1),
              "^udpm://239.255.76.67:7667.ttl=0: no multicast route [^\n]*"
              "ip route add 224.0.0.0/4 dev lo\n$");
}

TEST(MulticastRouteDeathTest, MissingForTheCanBusIsOneLineWithTheRemedy) {
  EXPECT_EXIT(ReportWithoutRoutes([] { OpenCanBus("udp:239.74.163.2:43113", ManualClock()); }),
              testing::ExitedWithCode(1),
              "^udp:239.74.163.2:43113: no multicast route [^\n]*"
              "ip route add 224.0.0.0/4 dev lo\n$");
}

}  // namespace
}  // namespace eod
