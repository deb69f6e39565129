#include <fmt/format.h>

#include "dbc/dbc_reader.h"

namespace eod::dbc {

using Kind = Token::Kind;
using Severity = Diagnostic::Severity;

void DbcReader::ReadAttributeDefinition() {
  Take();
  AttributeDefinition definition;
  if (Peek().kind == Kind::kWord && !AtStatement()) definition.kind = Take().text;
  const std::string name = ExpectString("an attribute name");
  const Token type = Peek();
  definition.type = ExpectWord("a type: INT, HEX, FLOAT, STRING or ENUM");
  if (definition.type == "INT" || definition.type == "HEX" || definition.type == "FLOAT") {
    while (Peek().kind == Kind::kNumber) Take();  // range
  } else if (definition.type == "ENUM") {
    while (Peek().kind == Kind::kString) {
      definition.choices.push_back(ExpectString("a choice"));
      TakeMark(",");
    }
  } else if (definition.type != "STRING") {
    throw SyntaxError{
        type, fmt::format("attribute type '{}': INT, HEX, FLOAT, STRING or ENUM", definition.type)};
  }
  definitions_[name] = std::move(definition);
  ExpectEnd();
}

std::string DbcReader::ReadAttributeValue(const AttributeDefinition* definition) {
  if (Peek().kind == Kind::kString) return ExpectString("a value");
  const Token token = Peek();
  if (token.kind != Kind::kNumber) {
    throw SyntaxError{token, fmt::format("expected a value, found '{}'", token.text)};
  }
  Take();
  if (definition == nullptr || definition->type != "ENUM") return std::string(token.text);
  const auto index = ToInteger(token.text);
  if (!index || *index < 0 || *index >= static_cast<int64_t>(definition->choices.size())) {
    throw SyntaxError{token, fmt::format("choice {} of an attribute that has {}", token.text,
                                         definition->choices.size())};
  }
  return definition->choices[static_cast<size_t>(*index)];
}

void DbcReader::ReadAttributeDefault() {
  Take();
  const Token token = Peek();
  const std::string name = ExpectString("an attribute name");
  const auto found = definitions_.find(name);
  if (found == definitions_.end()) {
    Report(Severity::kWarning, token, fmt::format("attribute \"{}\" is not defined", name));
    ReadAttributeValue(nullptr);
  } else {
    found->second.initial = ReadAttributeValue(&found->second);
    found->second.has_initial = true;
  }
  ExpectEnd();
}

void DbcReader::ReadAttribute() {
  Take();
  const Token token = Peek();
  const std::string name = ExpectString("an attribute name");
  const auto found = definitions_.find(name);
  if (found == definitions_.end()) {
    Report(Severity::kWarning, token, fmt::format("attribute \"{}\" is not defined", name));
  }
  const Subject subject = ReadSubject();
  std::string value = ReadAttributeValue(found == definitions_.end() ? nullptr : &found->second);
  if (subject.signal != nullptr) {
    subject.signal->attributes[name] = std::move(value);
  } else if (subject.kind == "BO_" && subject.message != nullptr) {
    subject.message->attributes[name] = std::move(value);
  } else if (subject.kind.empty()) {
    database_.attributes[name] = std::move(value);
  }
  ExpectEnd();
}

void DbcReader::ApplyDefaults() {
  for (const auto& [name, definition] : definitions_) {
    if (!definition.has_initial) continue;
    if (definition.kind.empty()) database_.attributes.emplace(name, definition.initial);
    for (Message& message : database_.messages) {
      if (definition.kind == "BO_") message.attributes.emplace(name, definition.initial);
      if (definition.kind != "SG_") continue;
      for (Signal& signal : message.signals) signal.attributes.emplace(name, definition.initial);
    }
  }
}

void DbcReader::ApplyLongNames() {
  const auto long_name = [](const std::map<std::string, std::string>& attributes, const char* name,
                            std::string& target) {
    const auto found = attributes.find(name);
    if (found != attributes.end() && !found->second.empty()) target = found->second;
  };
  for (Message& message : database_.messages) {
    long_name(message.attributes, "SystemMessageLongSymbol", message.name);
    for (Signal& signal : message.signals) {
      long_name(signal.attributes, "SystemSignalLongSymbol", signal.name);
    }
  }
}

}  // namespace eod::dbc
