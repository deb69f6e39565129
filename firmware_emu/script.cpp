#include "firmware_emu/script.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "firmware_emu/vocabulary.h"

namespace eod::box {
namespace {

using Kind = Statement::Kind;

constexpr std::string_view kStatementWords =
    "wait, hold, drive, turn, approach, expect, note, fail";

bool BeginsWithDigit(std::string_view word) {
  return !word.empty() && word.front() >= '0' && word.front() <= '9';
}

void RequireWord(WordReader& words, std::string_view word) {
  if (!words.TakeIf(word)) {
    const std::string found = words.at_end() ? "end of line" : std::string(words.Peek());
    throw std::runtime_error(fmt::format("'{}': allowed: {} TIME", found, word));
  }
}

void ParseUntil(Statement& statement, WordReader& words) {
  statement.condition = ParseCondition(words);
  RequireWord(words, "within");
  statement.duration = words.TakeDuration();
}

void ParseWait(Statement& statement, WordReader& words) {
  if (BeginsWithDigit(words.Peek())) {
    statement.kind = Kind::kWaitFor;
    statement.duration = words.TakeDuration();
  } else {
    statement.kind = Kind::kWaitUntil;
    ParseUntil(statement, words);
  }
}

void ParseHold(Statement& statement, WordReader& words) {
  constexpr std::array<std::string_view, 2> kForUntil{"for", "until"};
  if (words.TakeIf("preset")) {
    const int preset = words.TakeChoice(std::span(words::kPreset).subspan<1>()) + 1;
    statement.press = {.control = Control::kPreset, .choice = preset};
    statement.release = {.control = Control::kPreset, .choice = 0};
  } else {
    const uint32_t motions = words.TakeMotions();
    statement.press = {.control = Control::kPress, .motions = motions};
    statement.release = {.control = Control::kRelease, .motions = motions};
  }
  if (words.TakeChoice(kForUntil) == 0) {
    statement.kind = Kind::kHoldFor;
    statement.duration = words.TakeDuration();
  } else {
    statement.kind = Kind::kHoldUntil;
    ParseUntil(statement, words);
  }
}

void ParseWay(Statement& statement, std::string_view verb, WordReader& words) {
  statement.kind = Kind::kManoeuvre;
  statement.manoeuvre = ParseManoeuvre(verb, words);
  statement.duration = words.TakeIf("within") ? words.TakeDuration() : Manoeuvre::kUsualLimit;
}

Statement ParseStatement(WordReader& words) {
  Statement statement;
  const std::string verb = words.Take("an action");
  if (verb == "wait") {
    ParseWait(statement, words);
  } else if (verb == "hold") {
    ParseHold(statement, words);
  } else if (IsManoeuvreWord(verb)) {
    ParseWay(statement, verb, words);
  } else if (verb == "expect") {
    statement.kind = Kind::kExpect;
    statement.condition = ParseCondition(words);
  } else if (verb == "note") {
    statement.kind = Kind::kNote;
    statement.message = words.Take("a text in double quotes");
  } else if (verb == "fail") {
    statement.kind = Kind::kFail;
    statement.message = words.at_end() ? "the script says fail" : words.Take("a text");
  } else {
    if (!IsActionWord(verb)) {
      throw std::runtime_error(
          fmt::format("'{}': allowed: {}, {}", verb, kStatementWords, ActionWords()));
    }
    statement.kind = Kind::kAction;
    statement.action = ParseAction(verb, words);
  }
  words.RequireEnd();
  return statement;
}

std::string_view Trim(std::string_view line) {
  constexpr std::string_view kBlanks = " \t\r";
  const size_t first = line.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(kBlanks) - first + 1);
}

}  // namespace

Script ParseScript(std::string_view text, const std::filesystem::path& file) {
  Script script{.file = file, .statements = {}};
  for (int number = 1; !text.empty(); ++number) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    try {
      WordReader words(line);
      if (words.at_end()) continue;
      Statement statement = ParseStatement(words);
      statement.line = number;
      statement.text = Trim(line);
      script.statements.push_back(std::move(statement));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(fmt::format("{}:{}: {}", file.string(), number, error.what()));
    }
  }
  return script;
}

Script LoadScript(const std::filesystem::path& file) {
  std::ifstream in(file);
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (!in.good() && !in.eof()) {
    throw std::runtime_error(
        fmt::format("{}: cannot be read; give an operator script (*.boxscript)", file.string()));
  }
  return ParseScript(text, file);
}

}  // namespace eod::box
