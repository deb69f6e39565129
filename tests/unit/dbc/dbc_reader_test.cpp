#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dbc/database.h"
#include "tests/unit/dbc/samples.h"

namespace eod::dbc {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

Database Parse(std::string_view text) { return ParseDatabase(text, "test.dbc"); }

/// The only diagnostic, as "LINE:COLUMN text".
std::string OnlyDiagnostic(const Database& database) {
  EXPECT_THAT(database.diagnostics, SizeIs(1));
  if (database.diagnostics.empty()) return {};
  const Diagnostic& diagnostic = database.diagnostics.front();
  return std::to_string(diagnostic.line) + ":" + std::to_string(diagnostic.column) + " " +
         diagnostic.text;
}

constexpr std::string_view kMessage =
    "BO_ 400 SAFETY: 8 BOX\n SG_ Key : 12|3@1+ (1,0) [0|7] \"\" ROBOT\n";

TEST(DbcReader, ReadsMessageAndSignal) {
  const Database dut = Parse(
      "VERSION \"1.0\"\nBU_: BOX ROBOT\nBO_ 400 SAFETY: 8 BOX\n"
      " SG_ Supply : 48|8@1- (0.2,-1.5) [-10|50] \"V\" ROBOT,TESTER\n");
  EXPECT_THAT(dut.diagnostics, IsEmpty());
  EXPECT_EQ(dut.version, "1.0");
  EXPECT_THAT(dut.nodes, ElementsAre("BOX", "ROBOT"));
  ASSERT_THAT(dut.messages, SizeIs(1));
  const Message& message = dut.messages[0];
  EXPECT_EQ(message.id, 400u);
  EXPECT_EQ(message.length, 8);
  EXPECT_EQ(message.sender, "BOX");
  EXPECT_EQ(message.line, 3);
  const Signal& signal = message.signals.at(0);
  EXPECT_EQ(signal.start_bit, 48);
  EXPECT_EQ(signal.length, 8);
  EXPECT_EQ(signal.byte_order, ByteOrder::kIntel);
  EXPECT_TRUE(signal.is_signed);
  EXPECT_EQ(signal.factor, 0.2);
  EXPECT_EQ(signal.offset, -1.5);
  EXPECT_EQ(signal.minimum, -10);
  EXPECT_EQ(signal.maximum, 50);
  EXPECT_EQ(signal.unit, "V");
  EXPECT_THAT(signal.receivers, ElementsAre("ROBOT", "TESTER"));
  EXPECT_EQ(signal.line, 4);
}

TEST(DbcReader, ReadsByteOrderAsTheDeFactoStandardHasIt) {
  const Database dut = Parse("BO_ 1 M: 8 X\n SG_ A : 7|8@0+ (1,0) [0|0] \"\" Vector__XXX\n");
  EXPECT_EQ(dut.messages.at(0).signals.at(0).byte_order, ByteOrder::kMotorola);
  EXPECT_THAT(dut.messages[0].signals[0].receivers, IsEmpty());
}

TEST(DbcReader, TellsExtendedIdentifiersByBit31Alone) {
  // 2147484048 = 0x80000190; 1000000 has more than 11 bits without bit 31.
  const Database dut = Parse("BO_ 2147484048 E: 8 X\nBO_ 400 S: 8 X\nBO_ 1000000 W: 8 X\n");
  EXPECT_EQ(dut.FindMessage(400, true)->name, "E");
  EXPECT_EQ(dut.FindMessage(400, false)->name, "S");
  EXPECT_FALSE(dut.FindMessage("W")->extended);
  EXPECT_THAT(OnlyDiagnostic(dut), AllOf(StartsWith("3:1 "), HasSubstr("more than 11 bits")));
}

TEST(DbcReader, ReadsMultiplexing) {
  const Database dut = Parse(
      "BO_ 1 M: 8 X\n SG_ A M : 0|8@1+ (1,0) [0|0] \"\" X\n SG_ B m3 : 8|8@1+ (1,0) [0|0] \"\" X\n"
      " SG_ C m4M : 8|8@1+ (1,0) [0|0] \"\" X\n SG_ D mx : 8|8@1+ (1,0) [0|0] \"\" X\n");
  const auto& signals = dut.messages.at(0).signals;
  ASSERT_THAT(signals, SizeIs(3));
  EXPECT_TRUE(signals[0].multiplexing.is_selector);
  EXPECT_FALSE(signals[0].is_multiplexed());
  EXPECT_EQ(signals[1].multiplexing.selected_by, 3);
  EXPECT_EQ(signals[2].multiplexing.selected_by, 4);
  EXPECT_TRUE(signals[2].multiplexing.is_selector);
  EXPECT_THAT(OnlyDiagnostic(dut), StartsWith("5:8 'mx' is no multiplexor"));
}

TEST(DbcReader, TakesSectionsInAnyOrder) {
  const Database dut = Parse(
      "VAL_ 400 Key 0 \"Off\" 2 \"Operate\" ;\nCM_ SG_ 400 Key \"the key\";\n"
      "BA_ \"GenMsgCycleTime\" BO_ 400 20;\nBA_DEF_ BO_ \"GenMsgCycleTime\" INT 0 1000;\n" +
      std::string(kMessage));
  EXPECT_THAT(dut.diagnostics, IsEmpty());
  EXPECT_EQ(dut.messages.at(0).signals.at(0).labels.at(2), "Operate");
  EXPECT_EQ(dut.messages[0].signals[0].comment, "the key");
  EXPECT_EQ(dut.messages[0].cycle_time_ms(), 20);
}

TEST(DbcReader, TakesNewSymbolsThatLookLikeSections) {
  for (const char* symbols :
       {"NS_ :\n\tNS_DESC_\n\tCM_\n\tBA_DEF_\n\nBS_:\n", "NS_:\nCM_\nBA_\nBS_:\n", "NS_ :\n", ""}) {
    const Database dut = Parse(symbols + std::string("BU_: A\n") + std::string(kMessage));
    EXPECT_THAT(dut.diagnostics, IsEmpty()) << symbols;
    EXPECT_THAT(dut.messages, SizeIs(1)) << symbols;
  }
}

TEST(DbcReader, AppliesAttributesAndTheirDefaults) {
  const Database dut = Parse(
      "BO_ 1 A: 8 X\nBO_ 2 B: 8 X\nBO_ 3 C: 8 X\n"
      "BA_DEF_ BO_ \"Send\" ENUM \"Cyclic\",\"Event\",\"Both\";\nBA_DEF_ BO_ \"Id\" HEX 0 10;\n"
      "BA_DEF_ \"Bus\" STRING;\nBA_DEF_ BO_ \"F\" FLOAT 0 1;\n"
      "BA_DEF_DEF_ \"Send\" \"Cyclic\";\nBA_DEF_DEF_ \"Bus\" \"CAN\";\nBA_DEF_DEF_ \"F\" 0.5;\n"
      "BA_ \"Send\" BO_ 1 2;\nBA_ \"Send\" BO_ 2 \"Event\";\nBA_ \"Id\" BO_ 1 7;\n");
  EXPECT_THAT(dut.diagnostics, IsEmpty());
  EXPECT_EQ(dut.messages.at(0).attributes.at("Send"), "Both");   // by index
  EXPECT_EQ(dut.messages.at(1).attributes.at("Send"), "Event");  // by name
  EXPECT_EQ(dut.messages.at(2).attributes.at("Send"), "Cyclic");
  EXPECT_EQ(dut.messages.at(2).attributes.at("F"), "0.5");
  EXPECT_EQ(dut.messages.at(0).attributes.at("Id"), "7");
  EXPECT_EQ(dut.messages.at(1).attributes.count("Id"), 0u);
  EXPECT_EQ(dut.attributes.at("Bus"), "CAN");
}

TEST(DbcReader, ReadsValueTablesAndTypes) {
  const Database dut = Parse(
      "VAL_TABLE_ OnOff 1 \"On\" 0 \"Off\" ;\nBO_ 1 M: 8 X\n SG_ A : 0|32@1- (1,0) [0|0] \"\" X\n"
      " SG_ B : 32|1@1+ (1,0) [0|0] \"\" X\nVAL_ 1 B OnOff ;\nSIG_VALTYPE_ 1 A : 1;\n");
  EXPECT_THAT(dut.diagnostics, IsEmpty());
  EXPECT_EQ(dut.messages.at(0).signals.at(0).value_type, ValueType::kFloat);
  EXPECT_EQ(dut.messages.at(0).signals.at(1).labels.at(1), "On");
}

TEST(DbcReader, SkipsWhatDoesNotConcernFrames) {
  const Database dut = Parse(
      "BO_TX_BU_ 1 : A,B;\nEV_ E: 0 [0|1] \"\" 0 1 DUMMY_NODE_VECTOR0 X;\nSIG_GROUP_ 1 G 1 : A;\n"
      "BA_DEF_REL_ BU_SG_REL_ \"R\" INT 0 1;\nBA_REL_ \"R\" BU_SG_REL_ N SG_ 1 A 1;\n"
      "SG_MUL_VAL_ 1 B A 1-1;\nBO_ 3221225472 VECTOR__INDEPENDENT_SIG_MSG: 0 Vector__XXX\n"
      " SG_ Lost : 0|8@1+ (1,0) [0|0] \"\" Vector__XXX\nCM_ SG_ 3221225472 Lost \"x\";\n" +
      std::string(kMessage));
  EXPECT_THAT(dut.diagnostics, IsEmpty());
  EXPECT_THAT(dut.messages, SizeIs(1));
}

TEST(DbcReader, ReportsABadSignalAndKeepsTheRest) {
  const Database dut = Parse(
      "BO_ 1 M: 8 X\n SG_ A : 0|8@1+ (1,0) [0|0] \"\" X\n SG_ B : 8|65@1+ (1,0) [0|0] \"\" X\n"
      " SG_ C : 16|8@1+ (1 0) [0|0] \"\" X\n SG_ D : 24|8@1+ (1,0) [0|0] \"\" X\n");
  ASSERT_THAT(dut.messages.at(0).signals, SizeIs(2));
  EXPECT_EQ(dut.messages[0].signals[1].name, "D");
  ASSERT_THAT(dut.diagnostics, SizeIs(2));
  EXPECT_EQ(dut.diagnostics[0].line, 3);
  EXPECT_EQ(dut.diagnostics[0].column, 10);
  EXPECT_THAT(dut.diagnostics[0].text, HasSubstr("length 1..64"));
  EXPECT_EQ(dut.diagnostics[1].line, 4);
  EXPECT_EQ(dut.diagnostics[1].column, 21);
  EXPECT_THAT(dut.diagnostics[1].text, HasSubstr("expected ',', found '0'"));
}

TEST(DbcReader, ReportsABadMessageOnceAndDropsItsSignals) {
  const Database dut =
      Parse("BO_ x M: 8 X\n SG_ A : 0|8@1+ (1,0) [0|0] \"\" X\n" + std::string(kMessage));
  EXPECT_THAT(dut.messages, SizeIs(1));
  EXPECT_EQ(OnlyDiagnostic(dut),
            "1:5 expected a message id, found 'x'; skipped to the next statement");
}

TEST(DbcReader, ACommentWithoutItsSemicolonSwallowsNothing) {
  const Database dut = Parse("CM_ \"hello\"\n" + std::string(kMessage));
  EXPECT_THAT(dut.messages, SizeIs(1));
  EXPECT_EQ(dut.comment, "hello");
  EXPECT_EQ(OnlyDiagnostic(dut), "2:1 the statement before misses its ';'");
  EXPECT_EQ(dut.diagnostics[0].severity, Diagnostic::Severity::kWarning);
}

TEST(DbcReader, SkipsUnknownStatementsToTheNextKeyword) {
  const Database dut = Parse("BOX_ 1 2 3\nmore of it\n" + std::string(kMessage));
  EXPECT_THAT(dut.messages, SizeIs(1));
  EXPECT_THAT(OnlyDiagnostic(dut), StartsWith("1:1 'BOX_' is no section keyword"));
}

TEST(DbcReader, ReportsDuplicatesAndLostReferences) {
  const Database dut = Parse(std::string(kMessage) +
                             "BO_ 400 AGAIN: 8 X\nVAL_ 400 Kay 0 \"Off\" ;\n"
                             "CM_ BO_ 401 \"who\";\n");
  ASSERT_THAT(dut.diagnostics, SizeIs(3));
  EXPECT_THAT(dut.diagnostics[0].text, HasSubstr("id 400 is that of SAFETY in line 1"));
  EXPECT_THAT(dut.diagnostics[1].text, HasSubstr("has no signal Kay"));
  EXPECT_EQ(dut.diagnostics[1].column, 10);
  EXPECT_THAT(dut.diagnostics[2].text, HasSubstr("no message has the id 401"));
}

TEST(DbcReader, WarnsOfASignalOutsideItsMessage) {
  // Motorola start 7, 9 bits: byte 0 whole and the MSB of byte 1, which the message lacks.
  const Database dut = Parse("BO_ 1 M: 1 X\n SG_ A : 7|9@0+ (1,0) [0|0] \"\" X\n");
  EXPECT_THAT(dut.messages.at(0).signals, SizeIs(1));
  EXPECT_EQ(OnlyDiagnostic(dut), "2:6 signal A reaches byte 1 of message M, which has 1 bytes");
}

TEST(DbcReader, ReadsCarriageReturnsAndNoFinalNewline) {
  const Database dut =
      Parse("VERSION \"\"\r\n\r\nBO_ 1 M: 8 X\r\n SG_ A : 0|8@1+ (1,0) [0|1] \"\" X");
  EXPECT_THAT(dut.diagnostics, IsEmpty());
  EXPECT_EQ(dut.messages.at(0).signals.at(0).line, 4);
}

TEST(DbcReader, RestoresLongNames) {
  const Database dut = Parse(
      "BO_ 1 Short: 8 X\nBA_DEF_ BO_ \"SystemMessageLongSymbol\" STRING;\n"
      "BA_DEF_DEF_ \"SystemMessageLongSymbol\" \"\";\n"
      "BA_ \"SystemMessageLongSymbol\" BO_ 1 \"A_name_of_more_than_thirty_two_characters\";\n");
  EXPECT_EQ(dut.messages.at(0).name, "A_name_of_more_than_thirty_two_characters");
}

TEST(DbcReader, SurvivesEveryTruncationOfTheShippedFile) {
  std::ifstream stream(std::filesystem::path(EOD_DATA_DIR) / "dbc/control_box.dbc");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  ASSERT_GT(text.size(), 1000u);
  for (size_t length = 0; length < text.size(); length += 97) {
    EXPECT_LE(Parse(std::string_view(text).substr(0, length)).messages.size(), 18u);
  }
}

TEST(DbcReader, SurvivesDamagedFiles) {
  std::ifstream stream(std::filesystem::path(EOD_DATA_DIR) / "dbc/control_box.dbc");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  Dice dice(2026);
  for (int round = 0; round < 100; ++round) {
    std::string damaged = text;
    for (int i = 0; i < 20; ++i) {
      damaged[dice.Bits() % damaged.size()] = static_cast<char>(dice.Roll(0, 255));
    }
    EXPECT_LE(Parse(damaged).messages.size(), 18u);
  }
}

TEST(LoadDatabase, TakesTheShippedFileWithoutAWord) {
  const Database dut = LoadDatabase(std::filesystem::path(EOD_DATA_DIR) / "dbc/control_box.dbc");
  EXPECT_THAT(dut.diagnostics, IsEmpty());
  EXPECT_THAT(dut.messages, SizeIs(18));  // domain.md 6.2
  for (const Message& message : dut.messages) EXPECT_NE(message.comment, "") << message.name;
}

TEST(LoadDatabase, RefusesErrorsWithFileLineAndColumn) {
  const auto file = std::filesystem::path(testing::TempDir()) / "dbc_reader_test_broken.dbc";
  std::ofstream(file) << "BO_ 1 M: 8 X\n SG_ A : 0|8@1+ (1,0) [0|0] X\n";
  EXPECT_EQ(ErrorOf([&] { LoadDatabase(file); }),
            file.string() + ":2:29: expected a unit, found 'X'; skipped to the next statement");
  std::ofstream(file) << "VERSION \"\"\n";
  EXPECT_THAT(ErrorOf([&] { LoadDatabase(file); }), HasSubstr("has no message"));
  std::filesystem::remove(file);
  EXPECT_THAT(ErrorOf([&] { LoadDatabase(file); }), HasSubstr("cannot be read"));
}

}  // namespace
}  // namespace eod::dbc
