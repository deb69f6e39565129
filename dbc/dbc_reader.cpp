#include "dbc/dbc_reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "dbc/text_encoding.h"

namespace eod::dbc {

using Kind = Token::Kind;
using Severity = Diagnostic::Severity;

const DbcReader::Section* DbcReader::FindSection(std::string_view keyword) {
  using R = DbcReader;
  static constexpr std::array kSections = {
      Section{"VERSION", &R::ReadVersion, false},
      Section{"NS_", &R::ReadNewSymbols, false},
      Section{"BS_", &R::ReadBusSpeed, false},
      Section{"BU_", &R::ReadNodes, false},
      Section{"VAL_TABLE_", &R::ReadValueTable, false},
      Section{"BO_", &R::ReadMessage, false},
      Section{"SG_", &R::ReadSignal, false},
      Section{"BA_DEF_", &R::ReadAttributeDefinition, false},
      Section{"CM_", &R::ReadComment, true},
      Section{"VAL_", &R::ReadValues, true},
      Section{"SIG_VALTYPE_", &R::ReadValueType, true},
      Section{"BA_DEF_DEF_", &R::ReadAttributeDefault, true},
      Section{"BA_", &R::ReadAttribute, true},
      // Known, and of no meaning for reading frames.
      Section{"BO_TX_BU_", &R::SkipStatement, false},
      Section{"EV_", &R::SkipStatement, false},
      Section{"EV_DATA_", &R::SkipStatement, false},
      Section{"ENVVAR_DATA_", &R::SkipStatement, false},
      Section{"SGTYPE_", &R::SkipStatement, false},
      Section{"SGTYPE_VAL_", &R::SkipStatement, false},
      Section{"SIG_TYPE_REF_", &R::SkipStatement, false},
      Section{"SIGTYPE_VALTYPE_", &R::SkipStatement, false},
      Section{"SIG_GROUP_", &R::SkipStatement, false},
      Section{"SG_MUL_VAL_", &R::SkipStatement, false},
      Section{"CAT_DEF_", &R::SkipStatement, false},
      Section{"CAT_", &R::SkipStatement, false},
      Section{"FILTER", &R::SkipStatement, false},
      Section{"BA_DEF_REL_", &R::SkipStatement, false},
      Section{"BA_DEF_DEF_REL_", &R::SkipStatement, false},
      Section{"BA_REL_", &R::SkipStatement, false},
      Section{"BA_DEF_SGTYPE_", &R::SkipStatement, false},
      Section{"BA_SGTYPE_", &R::SkipStatement, false},
      Section{"NS_DESC_", &R::SkipStatement, false},
  };
  const auto* found = std::find_if(kSections.begin(), kSections.end(),
                                   [&](const Section& s) { return s.keyword == keyword; });
  return found == kSections.end() ? nullptr : found;
}

DbcReader::DbcReader(std::string_view text) : tokens_(Tokenize(text)) {}

Database DbcReader::Read(const std::filesystem::path& file) {
  database_.file = file;
  std::vector<std::pair<size_t, Statement>> later;
  while (Peek().kind != Kind::kEnd) {
    const Token& token = Peek();
    const Section* section = token.kind == Kind::kWord ? FindSection(token.text) : nullptr;
    if (section == nullptr) {
      Report(Severity::kError, token,
             fmt::format("'{}' is no section keyword; skipped to the next one", token.text));
      Take();
      SkipToStatement();
    } else if (section->speaks_of_messages) {
      later.emplace_back(at_, section->read);
      SkipStatement();
    } else {
      ReadStatement(section->read);
    }
  }
  for (const auto& [position, statement] : later) {
    at_ = position;
    ReadStatement(statement);
  }
  ApplyDefaults();
  ApplyLongNames();
  std::stable_sort(database_.diagnostics.begin(), database_.diagnostics.end(),
                   [](const Diagnostic& a, const Diagnostic& b) {
                     return std::pair(a.line, a.column) < std::pair(b.line, b.column);
                   });
  return std::move(database_);
}

void DbcReader::ReadStatement(Statement statement) {
  const bool continues_message = statement == &DbcReader::ReadSignal;
  if (!continues_message) in_message_ = drop_signals_ = false;
  try {
    (this->*statement)();
  } catch (const SyntaxError& error) {
    Report(Severity::kError, error.token, error.text + "; skipped to the next statement");
    SkipToStatement();
  }
}

const Token& DbcReader::Peek(size_t ahead) const {
  return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
}

Token DbcReader::Take() {
  const Token token = Peek();
  if (at_ + 1 < tokens_.size()) ++at_;
  return token;
}

bool DbcReader::AtStatement() const {
  const Token& token = Peek();
  if (token.kind == Kind::kEnd) return true;
  return token.starts_line && token.kind == Kind::kWord && FindSection(token.text) != nullptr;
}

void DbcReader::SkipToStatement() {
  while (!AtStatement()) Take();
}

void DbcReader::SkipStatement() {
  Take();
  while (!AtStatement()) {
    if (TakeMark(";")) return;
    Take();
  }
}

void DbcReader::Report(Severity severity, const Token& at, std::string text) {
  database_.diagnostics.push_back({severity, at.line, at.column, std::move(text)});
}

namespace {

std::string Shown(const Token& token) {
  if (token.kind == Kind::kEnd) return "the end of the file";
  if (token.kind == Kind::kString) return fmt::format("\"{}\"", token.text.substr(0, 40));
  return fmt::format("'{}'", token.text);
}

}  // namespace

bool DbcReader::TakeMark(std::string_view mark) {
  const bool is_it = Peek().Is(Kind::kMark, mark);
  if (is_it) Take();
  return is_it;
}

void DbcReader::ExpectMark(std::string_view mark) {
  if (TakeMark(mark)) return;
  throw SyntaxError{Peek(), fmt::format("expected '{}', found {}", mark, Shown(Peek()))};
}

std::string_view DbcReader::ExpectWord(std::string_view what) {
  if (Peek().kind == Kind::kWord && !AtStatement()) return Take().text;
  throw SyntaxError{Peek(), fmt::format("expected {}, found {}", what, Shown(Peek()))};
}

double DbcReader::ExpectNumber(std::string_view what) {
  if (Peek().kind == Kind::kNumber) return ToNumber(Take().text);
  throw SyntaxError{Peek(), fmt::format("expected {}, found {}", what, Shown(Peek()))};
}

int64_t DbcReader::ExpectInteger(std::string_view what) {
  const bool is_number = Peek().kind == Kind::kNumber;
  const auto value = is_number ? ToInteger(Peek().text) : std::nullopt;
  if (!value) {
    throw SyntaxError{Peek(), fmt::format("expected {}, found {}", what, Shown(Peek()))};
  }
  Take();
  return *value;
}

std::string DbcReader::ExpectString(std::string_view what) {
  if (Peek().kind != Kind::kString) {
    throw SyntaxError{Peek(), fmt::format("expected {}, found {}", what, Shown(Peek()))};
  }
  if (!Peek().is_closed) {
    throw SyntaxError{Peek(), fmt::format("{} misses its closing quote", what)};
  }
  return Unescape(Take().text);
}

void DbcReader::ExpectEnd() {
  if (TakeMark(";")) return;
  if (!AtStatement()) {
    throw SyntaxError{Peek(), fmt::format("expected ';', found {}", Shown(Peek()))};
  }
  Report(Severity::kWarning, Peek(), "the statement before misses its ';'");
}

void DbcReader::ReadVersion() {
  Take();
  if (Peek().kind == Kind::kString) database_.version = ExpectString("a version");
  TakeMark(";");
}

void DbcReader::ReadNewSymbols() {
  Take();
  TakeMark(":");
  // A symbol stands alone on its line; the first section has something behind its keyword.
  while (Peek().kind == Kind::kWord && (Peek(1).starts_line || Peek(1).kind == Kind::kEnd)) Take();
}

void DbcReader::ReadBusSpeed() {
  Take();
  SkipToStatement();
}

void DbcReader::ReadNodes() {
  Take();
  ExpectMark(":");
  while (Peek().kind == Kind::kWord && !AtStatement()) database_.nodes.emplace_back(Take().text);
  TakeMark(";");
}

Database ParseDatabase(std::string_view text, const std::filesystem::path& file) {
  const std::string utf8 = ToUtf8(text);
  return DbcReader(utf8).Read(file);
}

}  // namespace eod::dbc
