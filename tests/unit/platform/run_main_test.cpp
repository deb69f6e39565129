#include "platform/run_main.h"

#include <array>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "platform/station_options.h"

namespace eod {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct Outcome {
  int status = -1;
  bool did_run = false;
  std::string out;
  std::string err;
};

/// Runs a program with the station's options on `arguments`.
Outcome RunThing(
    std::vector<std::string> arguments, StationOptions& options,
    const std::function<void()>& body = [] {}) {
  arguments.insert(arguments.begin(), "/usr/bin/eod-thing");
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  CLI::App app("Does a thing.");
  AddBusOptions(app, options);
  AddStationOptions(app, options);
  Outcome outcome;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  outcome.status = RunMain(app, "1.2.3", static_cast<int>(argv.size()), argv.data(), [&] {
    outcome.did_run = true;
    body();
  });
  outcome.out = testing::internal::GetCapturedStdout();
  outcome.err = testing::internal::GetCapturedStderr();
  return outcome;
}

Outcome RunThing(
    std::vector<std::string> arguments, const std::function<void()>& body = [] {}) {
  StationOptions options;
  return RunThing(std::move(arguments), options, body);
}

TEST(RunMain, RunsTheBodyAndGivesZero) {
  const Outcome dut = RunThing({});
  EXPECT_TRUE(dut.did_run);
  EXPECT_EQ(dut.status, 0);
  EXPECT_EQ(dut.err, "");
}

TEST(RunMain, PrintsAnExceptionAsOneLineAndGivesOne) {
  const Outcome dut = RunThing({}, [] { throw std::runtime_error("box.dbc:3: no\nsuch thing\n"); });
  EXPECT_EQ(dut.status, 1);
  EXPECT_EQ(dut.err, "eod-thing: box.dbc:3: no such thing\n");
}

TEST(RunMain, PrintsReasonAndUsageOfBadArgumentsAndGivesTwo) {
  const Outcome dut = RunThing({"--colour", "red"});
  EXPECT_EQ(dut.status, 2);
  EXPECT_FALSE(dut.did_run);
  EXPECT_THAT(dut.err, StartsWith("eod-thing: The following arguments were not expected: "));
  EXPECT_THAT(dut.err, HasSubstr("Usage:"));
  EXPECT_EQ(dut.out, "");
}

TEST(RunMain, LetsTheBodyRefuseArgumentsToo) {
  const Outcome dut = RunThing({}, [] { throw CLI::ValidationError("--a", "not with --b"); });
  EXPECT_EQ(dut.status, 2);
  EXPECT_THAT(dut.err, StartsWith("eod-thing: --a: not with --b\n"));
}

TEST(RunMain, PrintsHelpAndVersion) {
  const Outcome help = RunThing({"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_FALSE(help.did_run);
  EXPECT_THAT(help.out, HasSubstr("Does a thing."));
  const Outcome version = RunThing({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.out, "eod-thing 1.2.3\n");
}

TEST(RunMain, SurvivesAReaderThatWentAway) {
  const Outcome dut = RunThing({}, [] {
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    ::close(ends[0]);
    EXPECT_EQ(::write(ends[1], "x", 1), -1);
    ::close(ends[1]);
  });
  EXPECT_EQ(dut.status, 0);
}

TEST(StationOptions, ArriveWhereTheyBelong) {
  StationOptions dut;
  const Outcome outcome = RunThing({"--bus", "socketcan:can0", "--can-ttl", "1", "--lcm-url",
                                    "memq://", "--channel-prefix", "A_", "--describe"},
                                   dut);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(dut.bus_url, "socketcan:can0");
  EXPECT_EQ(dut.bus.multicast_ttl, 1);
  EXPECT_EQ(dut.lcm.url, "memq://");
  EXPECT_EQ(dut.lcm.channel_prefix, "A_");
  EXPECT_TRUE(dut.describe);
}

TEST(StationOptions, StayOnThisHostUnlessTold) {
  StationOptions dut;
  RunThing({}, dut);
  EXPECT_EQ(dut.bus_url, "udp:239.74.163.2:43113");
  EXPECT_EQ(dut.bus.multicast_ttl, 0);
}

TEST(StationOptions, RefuseABadPrefixOrTtlAsUsage) {
  EXPECT_EQ(RunThing({"--channel-prefix", "no spaces"}).status, 2);
  EXPECT_EQ(RunThing({"--can-ttl", "256"}).status, 2);
}

}  // namespace
}  // namespace eod
