#include <algorithm>

#include <fmt/format.h>

#include "dbc/dbc_reader.h"

namespace eod::dbc {

using Kind = Token::Kind;
using Severity = Diagnostic::Severity;

Message* DbcReader::ReadMessageReference() {
  const Token token = Peek();
  const int64_t file_id = ExpectInteger("a message id");
  const auto found = message_by_file_id_.find(static_cast<uint32_t>(file_id));
  if (found != message_by_file_id_.end()) return &database_.messages[found->second];
  constexpr uint32_t kOrphans = 0xC000'0000;
  if (file_id != kOrphans) {
    Report(Severity::kWarning, token, fmt::format("no message has the id {}", file_id));
  }
  return nullptr;
}

Signal* DbcReader::ReadSignalReference(Message* message) {
  const Token token = Peek();
  const std::string_view name = ExpectWord("a signal name");
  if (message == nullptr) return nullptr;
  const auto found = std::find_if(message->signals.begin(), message->signals.end(),
                                  [&](const Signal& signal) { return signal.name == name; });
  if (found != message->signals.end()) return &*found;
  Report(Severity::kWarning, token,
         fmt::format("message {} has no signal {}", message->name, name));
  return nullptr;
}

DbcReader::Subject DbcReader::ReadSubject() {
  Subject subject;
  if (Peek().kind != Kind::kWord) return subject;
  const Token token = Take();
  subject.kind = token.text;
  if (subject.kind == "BO_") {
    subject.message = ReadMessageReference();
  } else if (subject.kind == "SG_") {
    subject.message = ReadMessageReference();
    subject.signal = ReadSignalReference(subject.message);
  } else if (subject.kind == "BU_" || subject.kind == "EV_") {
    ExpectWord("a name");
  } else {
    throw SyntaxError{token, fmt::format("expected BU_, BO_, SG_ or EV_, found '{}'", token.text)};
  }
  return subject;
}

void DbcReader::ReadComment() {
  Take();
  const Subject subject = ReadSubject();
  const std::string text = ExpectString("a comment");
  if (subject.signal != nullptr) {
    subject.signal->comment = text;
  } else if (subject.kind == "BO_" && subject.message != nullptr) {
    subject.message->comment = text;
  } else if (subject.kind.empty()) {
    database_.comment = text;
  }
  ExpectEnd();
}

std::map<int64_t, std::string> DbcReader::ReadLabels() {
  std::map<int64_t, std::string> labels;
  while (Peek().kind == Kind::kNumber) {
    const int64_t raw = ExpectInteger("a raw value");
    labels[raw] = ExpectString("a label");
  }
  return labels;
}

void DbcReader::ReadValueTable() {
  Take();
  const std::string name{ExpectWord("a table name")};
  database_.value_tables[name] = ReadLabels();
  ExpectEnd();
}

void DbcReader::ReadValues() {
  Take();
  Signal* signal = nullptr;
  if (Peek().kind == Kind::kNumber) {
    Message* message = ReadMessageReference();
    signal = ReadSignalReference(message);
  } else {
    ExpectWord("a message id, or the name of an environment variable");
  }
  std::map<int64_t, std::string> labels;
  if (Peek().kind == Kind::kWord && !AtStatement()) {
    const Token table = Take();
    const auto found = database_.value_tables.find(std::string(table.text));
    if (found == database_.value_tables.end()) {
      throw SyntaxError{table, fmt::format("no VAL_TABLE_ is named {}", table.text)};
    }
    labels = found->second;
  } else {
    labels = ReadLabels();
  }
  if (signal != nullptr) signal->labels = std::move(labels);
  ExpectEnd();
}

void DbcReader::ReadValueType() {
  Take();
  Message* message = ReadMessageReference();
  Signal* signal = ReadSignalReference(message);
  TakeMark(":");
  const Token token = Peek();
  const int64_t type = ExpectInteger("a value type: 0 integer, 1 float, 2 double");
  if (type < 0 || type > 2) {
    throw SyntaxError{token, fmt::format("value type {}: 0 integer, 1 float, 2 double", type)};
  }
  if (signal != nullptr) signal->value_type = static_cast<ValueType>(type);
  ExpectEnd();
}

}  // namespace eod::dbc
