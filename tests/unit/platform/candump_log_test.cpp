#include "platform/candump_log.h"

#include <chrono>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eod {
namespace {

using testing::HasSubstr;

TimePoint Moment() {
  return TimePoint{std::chrono::seconds{1436509052} + std::chrono::microseconds{249713}};
}

/// Lines as candump -L of can-utils 2020.11 writes them, and what they say.
struct Example {
  const char* line;
  CanFrame frame;
};

std::vector<Example> Examples() {
  return {
      {"(1436509052.249713) vcan0 044#2A366C2BBA",
       {.id = 0x44, .length = 5, .data = {0x2A, 0x36, 0x6C, 0x2B, 0xBA}, .stamp = Moment()}},
      {"(1436509052.249713) vcan0 7FF#", {.id = 0x7FF, .stamp = Moment()}},
      {"(1436509052.249713) vcan0 00000044#01",
       {.id = 0x44, .extended = true, .length = 1, .data = {1}, .stamp = Moment()}},
      {"(1436509052.249713) vcan0 1FFFFFFF#R4",
       {.id = 0x1FFFFFFF, .extended = true, .remote = true, .length = 4, .stamp = Moment()}},
      {"(1436509052.249713) vcan0 123#R", {.id = 0x123, .remote = true, .stamp = Moment()}},
      {"(1436509052.249713) vcan0 20000040#0000000000000000",
       {.id = 0x40, .error = true, .length = 8, .stamp = Moment()}},
      {"(1436509052.249713) vcan0 123##1AABB",
       {.id = 0x123,
        .fd = true,
        .bit_rate_switch = true,
        .length = 2,
        .data = {0xAA, 0xBB},
        .stamp = Moment()}},
      {"(1436509052.249713) vcan0 123##3",
       {.id = 0x123,
        .fd = true,
        .bit_rate_switch = true,
        .error_state_indicator = true,
        .stamp = Moment()}},
  };
}

TEST(CandumpLog, WritesEveryKindOfFrameAsCandumpDoes) {
  for (const Example& example : Examples()) {
    EXPECT_EQ(FormatCandumpLine(example.frame, "vcan0"), example.line);
  }
}

TEST(CandumpLog, ReadsEveryKindOfFrameThatCandumpWrites) {
  for (const Example& example : Examples()) {
    SCOPED_TRACE(example.line);
    const auto dut = ParseCandumpLine(example.line);
    ASSERT_TRUE(dut.has_value());
    EXPECT_TRUE(SameOnWire(*dut, example.frame));
    EXPECT_EQ(dut->stamp, Moment());
  }
}

TEST(CandumpLog, WritesVirtualTimeFromTheEpochWithTenDigits) {
  const CanFrame frame{.id = 1, .stamp = TimePoint{std::chrono::milliseconds{4}}};
  EXPECT_EQ(FormatCandumpLine(frame, "hub"), "(0000000000.004000) hub 001#");
}

TEST(CandumpLog, TakesADirectionAndACarriageReturn) {
  const auto dut = ParseCandumpLine("(1.000001) can0 123#11 T\r");
  ASSERT_TRUE(dut.has_value());
  EXPECT_EQ(dut->length, 1);
  EXPECT_EQ(ToUtime(dut->stamp), 1000001);
}

TEST(CandumpLog, TakesNanoseconds) {
  const auto dut = ParseCandumpLine("(1.000000007) can0 123#");
  ASSERT_TRUE(dut.has_value());
  EXPECT_EQ(dut->stamp.time_since_epoch(), std::chrono::nanoseconds{1'000'000'007});
}

TEST(CandumpLog, RefusesWhatIsNoFrame) {
  for (const char* line : {
           "",
           "123#11",                               // no stamp, no interface
           "(1.0) can0 12#11",                     // two digits of identifier
           "(1.0) can0 800#",                      // over 11 bits
           "(1.0) can0 3FFFFFFFF#",                // over 32 bits
           "(1.0) can0 123#1",                     // half a byte
           "(1.0) can0 123#112233445566778899",    // nine bytes in a classic frame
           "(1.0) can0 123#R9",                    // nine bytes asked for
           "(1.0) can0 123##",                     // FD without flags
           "(1.0) can0 123##0112233445566778899",  // nine bytes: no length of FD
           "(1.0) can0 123",                       // no data part
           "(1.0) can0  123#11",                   // no interface
           "(1.0x) can0 123#11",
           "(-1.0) can0 123#11",
           "(1.0) can0 123#11 trailing",
       }) {
    EXPECT_FALSE(ParseCandumpLine(line).has_value()) << line;
  }
}

TEST(CandumpLog, ReadsBackTheFileThatItWrote) {
  const std::string file = testing::TempDir() + "candump_log_test.log";
  {
    CandumpWriter writer(file, "vcan0");
    for (const Example& example : Examples()) writer.Write(example.frame);
  }
  const auto frames = ReadCandumpLog(file);
  ASSERT_EQ(frames.size(), Examples().size());
  for (size_t i = 0; i < frames.size(); ++i) {
    EXPECT_TRUE(SameOnWire(frames[i], Examples()[i].frame)) << Examples()[i].line;
  }
}

TEST(CandumpLog, NamesFileAndLineOfABadLine) {
  const std::string file = testing::TempDir() + "candump_log_bad.log";
  std::ofstream(file) << "(1.0) can0 123#11\n\n(1.0) can0 oops\n";
  try {
    ReadCandumpLog(file);
    FAIL() << "no exception";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr(file + ":3: '(1.0) can0 oops'"));
  }
}

TEST(CandumpLog, NamesAFileThatCannotBeReadOrWritten) {
  EXPECT_THAT([] { ReadCandumpLog("/nowhere/can.log"); },
              testing::ThrowsMessage<std::runtime_error>(
                  HasSubstr("/nowhere/can.log: No such file or directory")));
  EXPECT_THAT([] { CandumpWriter("/nowhere/can.log", "can0"); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("/nowhere/can.log: cannot be")));
}

}  // namespace
}  // namespace eod
