#include "firmware_emu/word_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "dbc/panel_state.h"

namespace eod::box {
namespace {

constexpr std::string_view kBlanks = " \t\r";
constexpr double kLongestDuration = 3600;  // [s]

[[noreturn]] void Refuse(std::string_view word, std::string_view allowed) {
  throw std::runtime_error(fmt::format("'{}': allowed: {}", word, allowed));
}

std::vector<std::string> SplitWords(std::string_view line) {
  std::vector<std::string> words;
  while (true) {
    line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
    if (line.empty() || line.front() == '#') return words;
    size_t end = 0;
    if (line.front() == '"') {
      line.remove_prefix(1);
      end = line.find('"');
      if (end == std::string_view::npos) Refuse(line, "text in double quotes that are closed");
      words.emplace_back(line.substr(0, end));
      line.remove_prefix(end + 1);
    } else {
      end = std::min(line.find_first_of(kBlanks), line.size());
      words.emplace_back(line.substr(0, end));
      line.remove_prefix(end);
    }
  }
}

// Takes a number from the front of `text`; what is left is the unit.
std::optional<double> SplitNumber(std::string_view& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<size_t>(end - text.data()));
  return value;
}

std::optional<int> MotionNumber(std::string_view word) {
  if (word.size() < 2 || word.size() > 3 || word.front() != 'M') return std::nullopt;
  int motion = 0;
  const char* last = word.data() + word.size();
  const auto [end, error] = std::from_chars(word.data() + 1, last, motion);
  if (error != std::errc{} || end != last) return std::nullopt;
  if (motion < 1 || motion > dbc::kMotionCount) return std::nullopt;
  return motion;
}

}  // namespace

WordReader::WordReader(std::string_view line) : words_(SplitWords(line)) {}

std::string_view WordReader::Peek() const { return at_end() ? std::string_view() : words_[next_]; }

bool WordReader::TakeIf(std::string_view word) {
  if (at_end() || words_[next_] != word) return false;
  ++next_;
  return true;
}

std::string WordReader::Take(std::string_view expected) {
  if (at_end()) Refuse("end of line", expected);
  return words_[next_++];
}

int WordReader::TakeChoice(std::span<const std::string_view> choices) {
  const std::string word = Take(JoinWords(choices));
  for (size_t i = 0; i < choices.size(); ++i) {
    if (!choices[i].empty() && choices[i] == word) return static_cast<int>(i);
  }
  Refuse(word, JoinWords(choices));
}

int WordReader::TakeInteger(int minimum, int maximum) {
  const std::string allowed = fmt::format("a whole number {}..{}", minimum, maximum);
  const std::string word = Take(allowed);
  int value = 0;
  const char* last = word.data() + word.size();
  const auto [end, error] = std::from_chars(word.data(), last, value);
  if (error != std::errc{} || end != last || value < minimum || value > maximum) {
    Refuse(word, allowed);
  }
  return value;
}

double WordReader::TakeNumber() {
  constexpr std::string_view kAllowed = "a number";
  const std::string word = Take(kAllowed);
  std::string_view rest = word;
  const std::optional<double> value = SplitNumber(rest);
  if (!value || !rest.empty()) Refuse(word, kAllowed);
  return *value;
}

double WordReader::TakePercent(int minimum, int maximum) {
  const std::string allowed = fmt::format("{}%..{}%", minimum, maximum);
  const std::string word = Take(allowed);
  std::string_view rest = word;
  const std::optional<double> value = SplitNumber(rest);
  if (!value || rest != "%" || *value < minimum || *value > maximum) Refuse(word, allowed);
  return *value / 100;
}

Duration WordReader::TakeDuration() {
  constexpr std::string_view kAllowed = "a time such as 2.5s or 200ms, up to 3600s";
  const std::string word = Take(kAllowed);
  std::string_view rest = word;
  const std::optional<double> value = SplitNumber(rest);
  if (!value || (rest != "s" && rest != "ms")) Refuse(word, kAllowed);
  const double seconds = rest == "s" ? *value : *value / 1000;
  if (seconds < 0 || seconds > kLongestDuration) Refuse(word, kAllowed);
  return std::chrono::microseconds(std::llround(seconds * 1e6));
}

uint32_t WordReader::TakeMotions() {
  uint32_t motions = 0;
  while (const std::optional<int> motion = MotionNumber(Peek())) {
    motions |= 1u << (*motion - 1);
    ++next_;
  }
  if (motions == 0) Refuse(at_end() ? "end of line" : Peek(), "M01 .. M22");
  return motions;
}

void WordReader::RequireEnd() const {
  if (!at_end()) Refuse(Peek(), "nothing more on this line");
}

std::string JoinWords(std::span<const std::string_view> words) {
  std::string joined;
  for (const std::string_view word : words) {
    if (word.empty()) continue;
    if (!joined.empty()) joined += ", ";
    joined += word;
  }
  return joined;
}

}  // namespace eod::box
