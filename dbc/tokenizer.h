#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eod::dbc {

/// A piece of DBC text. `text` points into the text that was tokenized.
struct Token {
  enum class Kind : uint8_t {
    kWord,    ///< keyword or name; may begin with a digit
    kNumber,  ///< such as 12, -40, 0.5, 1e+09
    kString,  ///< between quotes; `text` is without them, escapes as written
    kMark,    ///< one character: : ; | @ ( ) [ ] , + -
    kEnd,     ///< behind the last one
  };
  Kind kind = Kind::kEnd;
  std::string_view text;
  int line = 1;    ///< 1-based
  int column = 1;  ///< 1-based, in characters (UTF-8 code points)
  bool starts_line = false;
  bool is_closed = true;  ///< false: a string that misses its closing quote

  bool Is(Kind wanted, std::string_view wanted_text) const {
    return kind == wanted && text == wanted_text;
  }
};

/// Splits UTF-8 DBC text into tokens, the last of kind kEnd. Skips white space, `//` and `/* */`.
/// Takes any line end. A string without a closing quote ends with its first line.
std::vector<Token> Tokenize(std::string_view text);

/// Text of a string token with \" and \\ resolved.
std::string Unescape(std::string_view text);

/// Number of a kNumber token, whatever the locale; saturates at the largest double.
double ToNumber(std::string_view text);

/// Whole number of a kNumber token; empty if it has a fraction or does not fit.
std::optional<int64_t> ToInteger(std::string_view text);

}  // namespace eod::dbc
