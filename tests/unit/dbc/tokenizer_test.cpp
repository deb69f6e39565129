#include "dbc/tokenizer.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dbc/text_encoding.h"

namespace eod::dbc {
namespace {

using Kind = Token::Kind;
using testing::ElementsAre;

std::vector<std::string> Texts(std::string_view text) {
  std::vector<std::string> texts;
  for (const Token& token : Tokenize(text)) {
    if (token.kind != Kind::kEnd) texts.emplace_back(token.text);
  }
  return texts;
}

std::string Position(const Token& token) {
  return std::to_string(token.line) + ":" + std::to_string(token.column);
}

TEST(Tokenizer, SplitsASignalLineWithoutBlanks) {
  EXPECT_THAT(Texts("SG_ A:0|8@1+(0.5,-40)[-1|1e+09]\"%\" B,C"),
              ElementsAre("SG_", "A", ":", "0", "|", "8", "@", "1", "+", "(", "0.5", ",", "-40",
                          ")", "[", "-1", "|", "1e+09", "]", "%", "B", ",", "C"));
}

TEST(Tokenizer, TellsNamesThatBeginWithADigitFromNumbers) {
  const auto tokens = Tokenize("0_COUNTER 2017_5 1e5 12 1e5x");
  EXPECT_EQ(tokens[0].kind, Kind::kWord);
  EXPECT_EQ(tokens[1].kind, Kind::kWord);
  EXPECT_EQ(tokens[2].kind, Kind::kNumber);
  EXPECT_EQ(tokens[3].kind, Kind::kNumber);
  EXPECT_EQ(tokens[4].kind, Kind::kWord);
}

TEST(Tokenizer, CountsLinesOfEveryLineEnd) {
  const auto tokens = Tokenize("A\nB\r\nC\rD");
  EXPECT_EQ(Position(tokens[1]), "2:1");
  EXPECT_EQ(Position(tokens[2]), "3:1");
  EXPECT_EQ(Position(tokens[3]), "4:1");
}

TEST(Tokenizer, CountsColumnsInCharacters) {
  // "°C" is 3 bytes and 2 characters: quote, °, C, quote, blank = 5 columns before A.
  const auto tokens = Tokenize("\"\u00B0C\" A");
  EXPECT_EQ(Position(tokens[1]), "1:6");
}

TEST(Tokenizer, SaysWhatBeginsALine) {
  const auto tokens = Tokenize("BO_ 1\n  SG_ /* x */ A");
  EXPECT_TRUE(tokens[0].starts_line);
  EXPECT_FALSE(tokens[1].starts_line);
  EXPECT_TRUE(tokens[2].starts_line);
  EXPECT_FALSE(tokens[3].starts_line);
}

TEST(Tokenizer, SkipsComments) {
  EXPECT_THAT(Texts("A // B\nC /* D\nE */ F // no line end"), ElementsAre("A", "C", "F"));
  EXPECT_EQ(Position(Tokenize("/* 1\n2 */ A")[0]), "2:6");
}

TEST(Tokenizer, KeepsEscapesInStringsAndResolvesThemLater) {
  const auto tokens = Tokenize(R"("say \"no\"" A)");
  EXPECT_EQ(tokens[0].text, R"(say \"no\")");
  EXPECT_EQ(Unescape(tokens[0].text), R"(say "no")");
  EXPECT_EQ(tokens[1].text, "A");
}

TEST(Tokenizer, TakesStringsOfSeveralLines) {
  const auto tokens = Tokenize("\"one\ntwo\" A");
  EXPECT_EQ(tokens[0].text, "one\ntwo");
  EXPECT_EQ(Position(tokens[1]), "2:6");
}

TEST(Tokenizer, EndsAnOpenStringWithItsLine) {
  const auto tokens = Tokenize("A \"open\nB");
  EXPECT_FALSE(tokens[1].is_closed);
  EXPECT_EQ(tokens[1].text, "open");
  EXPECT_EQ(tokens[2].text, "B");
}

TEST(Tokenizer, SurvivesEveryTruncationOfALine) {
  const std::string line = "SG_ A m3M : 0|8@1- (-0.5e-3,+4) [0|1] \"a\\\"b\" X /* c */";
  for (size_t length = 0; length <= line.size(); ++length) {
    EXPECT_EQ(Tokenize(line.substr(0, length)).back().kind, Kind::kEnd);
  }
}

TEST(Numbers, AreReadWhateverTheLocale) {
  EXPECT_EQ(ToNumber("65.535"), 65.535);
  EXPECT_EQ(ToNumber("+1e+09"), 1e9);
  EXPECT_EQ(ToNumber("-.5"), -0.5);
}

TEST(Numbers, SaturateBeyondTheLargestDouble) {
  EXPECT_EQ(ToNumber("4.4E+481"), std::numeric_limits<double>::max());
  EXPECT_EQ(ToNumber("-4.4E+481"), -std::numeric_limits<double>::max());
  EXPECT_EQ(ToNumber("4.4E-481"), 0);
}

TEST(Numbers, AreWholeOnlyWithoutAFraction) {
  EXPECT_EQ(ToInteger("-2048"), -2048);
  EXPECT_EQ(ToInteger("3.0"), 3);
  EXPECT_EQ(ToInteger("18446744073709551615"), -1);  // the bits of an unsigned 64-bit raw value
  EXPECT_EQ(ToInteger("3.5"), std::nullopt);
  EXPECT_EQ(ToInteger("1e300"), std::nullopt);
}

TEST(Encoding, KeepsUtf8AndDropsItsMark) {
  EXPECT_EQ(ToUtf8("\u00B0C"), "\u00B0C");
  EXPECT_EQ(ToUtf8("\xEF\xBB\xBFVERSION"), "VERSION");
}

TEST(Encoding, ReadsWindows1252WhereTheTextIsNoUtf8) {
  EXPECT_EQ(ToUtf8("\xB0"
                   "C \x80"),
            "\u00B0C \u20AC");
}

}  // namespace
}  // namespace eod::dbc
