#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/socket.h>

#include "platform/file_descriptor.h"
#include "platform/socketcan_frame.h"
#include "tests/contract/can_bus_medium.h"

// Needs the right to make and change interfaces, and a virtual one, named by EOD_TEST_SOCKETCAN,
// that nobody else uses: each test makes it anew.
namespace eod {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr CanFrame kMarker{.id = 0x7FF, .length = 1, .data = {0xEE}};
constexpr CanFrame kStale{.id = 0x100, .length = 1, .data = {0x01}};

/// `ip link COMMAND`, with {} for the interface's name.
void Ip(const std::string& command) {
  const std::string line = "ip link " + fmt::format(fmt::runtime(command), SocketCanInterface());
  ASSERT_EQ(std::system(line.c_str()), 0) << line;
}

class SocketCanOutage : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_NE(SocketCanInterface(), "") << "EOD_TEST_SOCKETCAN names no interface";
    if (::if_nametoindex(SocketCanInterface().c_str()) != 0) Ip("del {}");
    MakeInterface();
    dut_ = Connect();
    peer_ = Connect();
  }

  static void MakeInterface() {
    Ip("add {} type vcan");
    Ip("set {} mtu 72");
    Ip("set {} up");
  }

  std::unique_ptr<CanBus> Connect() {
    return OpenCanBus("socketcan:" + SocketCanInterface(), clock_);
  }

  /// What a controller's driver reports; any program may put it onto a virtual interface.
  void InjectErrorFrame(const CanFrame& frame) {
    const FileDescriptor driver(::socket(AF_CAN, SOCK_RAW, CAN_RAW));
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = static_cast<int>(::if_nametoindex(SocketCanInterface().c_str()));
    ASSERT_EQ(::bind(driver.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    const canfd_frame raw = ToSocketCan(frame);
    ASSERT_EQ(::write(driver.get(), &raw, CAN_MTU), static_cast<ssize_t>(CAN_MTU));
  }

  /// Reads until the error frame that was injected before has been seen.
  void ReadErrorFrame(CanBus& bus) {
    const uint64_t before = bus.counters().error_frames;
    pollfd entry{.fd = bus.PollDescriptor(), .events = POLLIN, .revents = 0};
    ASSERT_EQ(::poll(&entry, 1, 5000), 1);
    EXPECT_FALSE(bus.Receive().has_value()) << "an error report is no data";
    ASSERT_EQ(bus.counters().error_frames, before + 1);
  }

  void ExpectTrafficBothWays() {
    EXPECT_EQ(dut_->Send(kMarker), SendOutcome::kSent);
    const auto at_peer = Await(*peer_);
    ASSERT_TRUE(at_peer.has_value());
    EXPECT_TRUE(SameOnWire(*at_peer, kMarker)) << "a frame of the outage was sent late";
    EXPECT_EQ(peer_->Send({.id = 0x321}), SendOutcome::kSent);
    const auto at_dut = Await(*dut_);
    ASSERT_TRUE(at_dut.has_value());
    EXPECT_EQ(at_dut->id, 0x321U);
  }

  void MaintainBoth() {
    dut_->Maintain(clock_.Now());
    peer_->Maintain(clock_.Now());
  }

  SteadyClock clock_;
  std::unique_ptr<CanBus> dut_;
  std::unique_ptr<CanBus> peer_;
};

constexpr CanFrame ErrorReport(uint32_t error_class) {
  return {.id = error_class, .error = true, .length = 8};
}

TEST_F(SocketCanOutage, DropsWhileTheInterfaceIsDownAndReturnsWithIt) {
  Ip("set {} down");
  EXPECT_EQ(dut_->Send(kStale), SendOutcome::kDropped);
  EXPECT_EQ(dut_->state(), CanBusState::kDown);
  EXPECT_EQ(dut_->counters().tx_dropped, 1U);
  MaintainBoth();
  EXPECT_EQ(dut_->state(), CanBusState::kDown);
  Ip("set {} up");
  MaintainBoth();
  EXPECT_EQ(dut_->state(), CanBusState::kUp);
  EXPECT_EQ(dut_->counters().restarts, 1U);
  ExpectTrafficBothWays();
}

TEST_F(SocketCanOutage, NoticesByReadingThatTheInterfaceWentDown) {
  Ip("set {} down");
  pollfd entry{.fd = dut_->PollDescriptor(), .events = POLLIN, .revents = 0};
  EXPECT_EQ(::poll(&entry, 1, 5000), 1);
  EXPECT_FALSE(dut_->Receive().has_value());
  EXPECT_EQ(dut_->state(), CanBusState::kDown);
  // Reported once: a loop that polls the descriptor does not spin.
  EXPECT_EQ(::poll(&entry, 1, 0), 0);
}

TEST_F(SocketCanOutage, NoticesWithoutTrafficThatTheInterfaceWentDownAndCameBack) {
  Ip("set {} down");
  MaintainBoth();
  EXPECT_EQ(dut_->state(), CanBusState::kDown);
  Ip("set {} up");
  MaintainBoth();
  EXPECT_FALSE(dut_->Receive().has_value());
  EXPECT_EQ(dut_->state(), CanBusState::kUp) << "an error of the past outage counted again";
  EXPECT_EQ(dut_->counters().restarts, 1U);
}

TEST_F(SocketCanOutage, BindsTheSameDescriptorToAnInterfaceThatWasMadeAgain) {
  const int descriptor = dut_->PollDescriptor();
  Ip("del {}");
  MaintainBoth();
  EXPECT_EQ(dut_->state(), CanBusState::kDown);
  EXPECT_EQ(dut_->Send(kStale), SendOutcome::kDropped);
  MakeInterface();
  MaintainBoth();
  EXPECT_EQ(dut_->state(), CanBusState::kUp);
  EXPECT_EQ(dut_->PollDescriptor(), descriptor);
  ExpectTrafficBothWays();
}

TEST_F(SocketCanOutage, NoticesAnInterfaceThatWasDeletedAndMadeBetweenTwoLooks) {
  Ip("del {}");
  MakeInterface();
  MaintainBoth();
  EXPECT_EQ(dut_->state(), CanBusState::kUp);
  EXPECT_EQ(dut_->counters().restarts, 1U);
  ExpectTrafficBothWays();
}

TEST_F(SocketCanOutage, KeepsItsFiltersWhenTheInterfaceIsMadeAgain) {
  const std::vector<CanFilter> marker_only{{.id = 0x7FF, .mask = 0x7FF}};
  dut_->SetFilters(marker_only);
  Ip("del {}");
  MakeInterface();
  MaintainBoth();
  peer_->Send({.id = 0x123});
  peer_->Send(kMarker);
  EXPECT_EQ(Await(*dut_)->id, kMarker.id);
}

TEST_F(SocketCanOutage, StillHearsOfBusOffWhenTheInterfaceWasMadeAgain) {
  Ip("del {}");
  MakeInterface();
  MaintainBoth();
  InjectErrorFrame(ErrorReport(CAN_ERR_BUSOFF));
  ReadErrorFrame(*dut_);
  EXPECT_EQ(dut_->state(), CanBusState::kBusOff);
}

TEST_F(SocketCanOutage, StartsOnAnInterfaceThatIsDown) {
  Ip("set {} down");
  MaintainBoth();
  dut_ = Connect();
  EXPECT_EQ(dut_->state(), CanBusState::kDown);
  Ip("set {} up");
  MaintainBoth();
  EXPECT_EQ(dut_->state(), CanBusState::kUp);
  ExpectTrafficBothWays();
}

TEST_F(SocketCanOutage, DropsDuringBusOffAndNeverSendsLate) {
  InjectErrorFrame(ErrorReport(CAN_ERR_BUSOFF));
  ReadErrorFrame(*dut_);
  ReadErrorFrame(*peer_);
  EXPECT_EQ(dut_->state(), CanBusState::kBusOff);
  EXPECT_EQ(dut_->Send(kStale), SendOutcome::kDropped);
  MaintainBoth();
  EXPECT_EQ(dut_->state(), CanBusState::kBusOff) << "only a restart ends it";
  InjectErrorFrame(ErrorReport(CAN_ERR_RESTARTED));
  ReadErrorFrame(*dut_);
  ReadErrorFrame(*peer_);
  EXPECT_EQ(dut_->state(), CanBusState::kUp);
  EXPECT_EQ(dut_->counters().restarts, 1U);
  ExpectTrafficBothWays();
}

TEST_F(SocketCanOutage, EndsBusOffWhenTheInterfaceIsTakenDownAndUp) {
  InjectErrorFrame(ErrorReport(CAN_ERR_BUSOFF));
  ReadErrorFrame(*dut_);
  ReadErrorFrame(*peer_);
  Ip("set {} down");
  MaintainBoth();
  EXPECT_EQ(dut_->state(), CanBusState::kDown);
  Ip("set {} up");
  MaintainBoth();
  EXPECT_EQ(dut_->state(), CanBusState::kUp);
  ExpectTrafficBothWays();
}

TEST_F(SocketCanOutage, CountsAWarningOfTheControllerAndStaysUp) {
  CanFrame warning = ErrorReport(CAN_ERR_CRTL);
  warning.data[1] = CAN_ERR_CRTL_RX_WARNING;
  InjectErrorFrame(warning);
  ReadErrorFrame(*dut_);
  ReadErrorFrame(*peer_);
  EXPECT_EQ(dut_->state(), CanBusState::kUp);
  EXPECT_EQ(dut_->counters().rx, 0U);
  ExpectTrafficBothWays();
}

TEST_F(SocketCanOutage, DropsAnFdFrameOnAClassicInterface) {
  Ip("set {} down");
  MaintainBoth();
  Ip("set {} mtu 16");
  Ip("set {} up");
  MaintainBoth();
  EXPECT_EQ(dut_->Send({.id = 1, .fd = true, .length = 12}), SendOutcome::kDropped);
  EXPECT_EQ(dut_->counters().tx_dropped, 1U);
  EXPECT_EQ(dut_->state(), CanBusState::kUp);
  ExpectTrafficBothWays();
}

TEST_F(SocketCanOutage, RefusesAnInterfaceThatIsNotCan) {
  EXPECT_THAT([this] { OpenCanBus("socketcan:lo", clock_); },
              ThrowsMessage<std::runtime_error>(HasSubstr("'lo' is not a CAN interface")));
}

}  // namespace
}  // namespace eod
