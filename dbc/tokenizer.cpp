#include "dbc/tokenizer.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace eod::dbc {
namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// Bytes above 127 count as letters: some files have names with umlauts.
bool IsWordPart(char c) {
  return IsDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

bool IsSpace(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

/// Characters of the number that `text` begins with; 0 if it begins with none.
size_t NumberLength(std::string_view text) {
  const auto digits = [&](size_t from) {
    size_t end = from;
    while (end < text.size() && IsDigit(text[end])) ++end;
    return end - from;
  };
  size_t at = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  const size_t whole = digits(at);
  at += whole;
  size_t fraction = 0;
  if (at < text.size() && text[at] == '.') {
    fraction = digits(at + 1);
    if (whole + fraction > 0) at += 1 + fraction;
  }
  if (whole + fraction == 0) return 0;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    const bool has_sign = at + 1 < text.size() && (text[at + 1] == '+' || text[at + 1] == '-');
    const size_t exponent = digits(at + (has_sign ? 2 : 1));
    if (exponent > 0) at += (has_sign ? 2 : 1) + exponent;
  }
  return at;
}

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::vector<Token> Run() {
    std::vector<Token> tokens;
    tokens.reserve(text_.size() / 4 + 1);
    do {
      SkipBlank();
      tokens.push_back(Next());
    } while (tokens.back().kind != Token::Kind::kEnd);
    return tokens;
  }

 private:
  bool AtEnd() const { return at_ >= text_.size(); }
  std::string_view Rest() const { return text_.substr(at_); }

  void Advance(size_t count) {
    for (const size_t end = at_ + count; at_ < end; ++at_) {
      const char c = text_[at_];
      const bool is_line_end =
          c == '\n' || (c == '\r' && (at_ + 1 >= text_.size() || text_[at_ + 1] != '\n'));
      if (is_line_end) {
        ++line_;
        column_ = 1;
        starts_line_ = true;
      } else if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) {
        ++column_;
      }
    }
  }

  void SkipBlank() {
    while (!AtEnd()) {
      const char c = text_[at_];
      if (IsSpace(c) || c == '\n' || c == '\r') {
        Advance(1);
      } else if (Rest().starts_with("//")) {
        Advance(std::min(Rest().find_first_of("\r\n"), Rest().size()));
      } else if (Rest().starts_with("/*")) {
        const size_t close = Rest().find("*/", 2);
        Advance(close == std::string_view::npos ? Rest().size() : close + 2);
      } else {
        return;
      }
    }
  }

  Token Next() {
    if (AtEnd()) return Take(Token::Kind::kEnd, 0);
    const char c = text_[at_];
    if (c == '"') return TakeString();
    const size_t number = NumberLength(Rest());
    const bool number_goes_on = number < Rest().size() && IsWordPart(Rest()[number]);
    if (number > 0 && !(number_goes_on && IsDigit(c))) return Take(Token::Kind::kNumber, number);
    size_t word = 0;
    while (word < Rest().size() &&
           (IsWordPart(Rest()[word]) || (word > 0 && Rest()[word] == '.'))) {
      ++word;
    }
    return word > 0 ? Take(Token::Kind::kWord, word) : Take(Token::Kind::kMark, 1);
  }

  Token Take(Token::Kind kind, size_t count) {
    Token token{kind, text_.substr(at_, count), line_, column_, starts_line_, true};
    starts_line_ = false;
    Advance(count);
    return token;
  }

  Token TakeString() {
    size_t close = 1;
    while (close < Rest().size() && Rest()[close] != '"') {
      close += Rest()[close] == '\\' && close + 1 < Rest().size() ? 2 : 1;
    }
    const bool is_closed = close < Rest().size();
    if (!is_closed) close = std::min(Rest().find_first_of("\r\n"), Rest().size());
    Token token = Take(Token::Kind::kString, is_closed ? close + 1 : close);
    token.text = token.text.substr(1, close - 1);
    token.is_closed = is_closed;
    // What follows a string of several lines does not begin a line.
    starts_line_ = false;
    return token;
  }

  std::string_view text_;
  size_t at_ = 0;
  int line_ = 1;
  int column_ = 1;
  bool starts_line_ = true;
};

}  // namespace

std::vector<Token> Tokenize(std::string_view text) { return Scanner(text).Run(); }

std::string Unescape(std::string_view text) {
  std::string plain;
  plain.reserve(text.size());
  for (size_t i = 0; i < text.size(); ++i) {
    const bool is_escape =
        text[i] == '\\' && i + 1 < text.size() && (text[i + 1] == '"' || text[i + 1] == '\\');
    if (is_escape) ++i;
    plain += text[i];
  }
  return plain;
}

double ToNumber(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc::result_out_of_range) return value;
  // Out of range means too large or too small; only the exponent's sign tells which.
  const bool is_tiny =
      text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos;
  const double huge = is_tiny ? 0 : std::numeric_limits<double>::max();
  return text.starts_with('-') ? -huge : huge;
}

std::optional<int64_t> ToInteger(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  int64_t whole = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), whole);
  if (error == std::errc() && end == text.data() + text.size()) return whole;
  uint64_t bits = 0;  // raw values of unsigned 64-bit signals
  const auto [bits_end, bits_error] = std::from_chars(text.data(), text.data() + text.size(), bits);
  if (bits_error == std::errc() && bits_end == text.data() + text.size()) {
    return static_cast<int64_t>(bits);
  }
  // Some writers put raw values as 3.0 or 1e3.
  const double value = ToNumber(text);
  if (std::floor(value) != value || std::abs(value) >= 0x1p63) return std::nullopt;
  return static_cast<int64_t>(value);
}

}  // namespace eod::dbc
