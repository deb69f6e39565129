// A DBC that reads well and yet does not fit the box: the codec says so at start.

#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/dbc/samples.h"

namespace eod::dbc {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

/// What the codec says of the shipped DBC with one piece of text replaced.
std::string CodecError(const std::string& from, const std::string& to) {
  const ControlMap map = LoadControlMap(ShippedMapFile());
  std::ifstream stream(map.dbc);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  const Database database = ParseDatabase(text, map.dbc);
  const std::string error = ErrorOf([&] { BoxCodec(database, map); });
  EXPECT_THAT(error, MatchesRegex(".*control_box\\.map\\.toml:[0-9]+: .*"));
  return error;
}

TEST(UnfitDbc, ProtectionMustBeWhole) {
  EXPECT_THAT(CodecError("BA_ \"E2EDataId\" BO_ 656 656;", ""),
              HasSubstr("message BOX_MOTION: end-to-end protection needs all of"));
  EXPECT_THAT(
      CodecError("BO_ 656 BOX_MOTION: 8 BOX\n SG_ E2E_Crc", "BO_ 656 BOX_MOTION: 8 BOX\n SG_ Crc"),
      HasSubstr("message BOX_MOTION: end-to-end protection needs all of"));
  EXPECT_THAT(CodecError("SG_ E2E_Crc : 0|8@1+", "SG_ E2E_Crc : 1|7@1+"),
              HasSubstr("E2E_Crc must be one whole byte"));
  EXPECT_THAT(CodecError("SG_ E2E_Cnt : 8|4@1+", "SG_ E2E_Cnt : 8|3@1+"),
              HasSubstr("E2E_Cnt 4 bit or more"));
}

TEST(UnfitDbc, SignalsMustLieInTheirMessage) {
  EXPECT_THAT(CodecError("SG_ BoxSupply : 48|8@1+", "SG_ BoxSupply : 60|8@1+"),
              HasSubstr("supply: signal BoxSupply: start bit 60, length 8 bit: reaches byte 8"));
}

TEST(UnfitDbc, MultiplexedSignalsAreNotTaken) {
  EXPECT_THAT(CodecError("SG_ BoxSupply :", "SG_ BoxSupply m1 :"), HasSubstr("is multiplexed"));
}

TEST(UnfitDbc, FactorsMustNotBeZero) {
  EXPECT_THAT(CodecError("SG_ BoxSupply : 48|8@1+ (0.2,0)", "SG_ BoxSupply : 48|8@1+ (0,0)"),
              HasSubstr("the factor must be a number other than 0"));
}

TEST(UnfitDbc, LengthsMustBeThoseOfCanFrames) {
  EXPECT_THAT(CodecError("BO_ 400 BOX_SAFETY: 8 BOX", "BO_ 400 BOX_SAFETY: 13 BOX"),
              HasSubstr("message BOX_SAFETY has 13 bytes"));
}

TEST(UnfitDbc, StandardIdentifiersHaveElevenBits) {
  EXPECT_THAT(CodecError("BO_ 144 BOX_EMCY", "BO_ 70000 BOX_EMCY"), HasSubstr("more than 11 bits"));
}

TEST(UnfitDbc, OneNodeIsNotBothEnds) {
  EXPECT_THAT(CodecError("BO_ 400 BOX_SAFETY: 8 BOX", "BO_ 400 BOX_SAFETY: 8 ROBOT"),
              HasSubstr("node ROBOT sends messages of both"));
}

TEST(UnfitDbc, LabelsMustBeThere) {
  EXPECT_THAT(
      CodecError("1 \"Enabled\" 2 \"Panic\"", "1 \"Enable\" 2 \"Panic\""),
      HasSubstr("deadman: signal Deadman has no label \"Enabled\"; did you mean \"Enable\"?"));
}

}  // namespace
}  // namespace eod::dbc
