#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "dbc/database.h"
#include "dbc/tokenizer.h"

namespace eod::dbc {

/// Reads the statements of one DBC text into a Database.
///
/// A statement begins with a section keyword that begins a line. A statement that cannot be taken
/// is reported, and reading goes on at the next one. Statements that speak of messages (CM_, BA_,
/// VAL_, SIG_VALTYPE_) are read last, so that sections may come in any order.
class DbcReader {
 public:
  /// `text` must be UTF-8 and outlive the reader.
  explicit DbcReader(std::string_view text);

  Database Read(const std::filesystem::path& file);

 private:
  /// What a CM_, BA_ or VAL_ speaks of. All null: the network, or something that is not kept.
  struct Subject {
    std::string_view kind;  ///< "", "BU_", "BO_", "SG_", "EV_"
    Message* message = nullptr;
    Signal* signal = nullptr;
  };
  struct AttributeDefinition {
    std::string_view kind;  ///< as Subject::kind
    std::string_view type;  ///< INT, HEX, FLOAT, STRING, ENUM
    std::vector<std::string> choices;
    std::string initial;  ///< BA_DEF_DEF_
    bool has_initial = false;
  };
  struct SyntaxError {
    Token token;
    std::string text;
  };
  using Statement = void (DbcReader::*)();
  struct Section {
    std::string_view keyword;
    Statement read;
    bool speaks_of_messages;
  };
  static const Section* FindSection(std::string_view keyword);

  // Tokens (dbc_reader.cpp).
  const Token& Peek(size_t ahead = 0) const;
  Token Take();
  bool AtStatement() const;
  bool TakeMark(std::string_view mark);
  void ExpectMark(std::string_view mark);
  std::string_view ExpectWord(std::string_view what);
  double ExpectNumber(std::string_view what);
  int64_t ExpectInteger(std::string_view what);
  std::string ExpectString(std::string_view what);
  void ExpectEnd();
  void SkipToStatement();
  void SkipStatement();
  void Report(Diagnostic::Severity severity, const Token& at, std::string text);
  void ReadStatement(Statement statement);

  // Structure (dbc_reader.cpp, dbc_reader_messages.cpp).
  void ReadVersion();
  void ReadNewSymbols();
  void ReadBusSpeed();
  void ReadNodes();
  void ReadMessage();
  void ReadSignal();
  Multiplexing ReadMultiplexing();
  void ReadLayout(Signal& signal);
  void ReadScale(Signal& signal);
  void ReadReceivers(Signal& signal);
  void CheckLayout(const Signal& signal, const Message& message, const Token& at);

  // What the file says about it (dbc_reader_notes.cpp).
  Message* ReadMessageReference();
  Signal* ReadSignalReference(Message* message);
  Subject ReadSubject();
  void ReadComment();
  void ReadValueTable();
  void ReadValues();
  void ReadValueType();
  std::map<int64_t, std::string> ReadLabels();

  // Attributes (dbc_reader_attributes.cpp).
  void ReadAttributeDefinition();
  void ReadAttributeDefault();
  void ReadAttribute();
  std::string ReadAttributeValue(const AttributeDefinition* definition);
  void ApplyDefaults();
  void ApplyLongNames();

  std::vector<Token> tokens_;
  size_t at_ = 0;
  Database database_;
  std::unordered_map<uint32_t, size_t> message_by_file_id_;  ///< id as in the file, with bit 31
  std::map<std::string, AttributeDefinition> definitions_;
  bool in_message_ = false;    ///< SG_ lines belong to the last message
  bool drop_signals_ = false;  ///< SG_ lines belong to a BO_ that was not kept
};

}  // namespace eod::dbc
