#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "platform/time.h"

namespace eod::box {

/// Takes one line of an operator script apart, word by word.
///
/// Words stand apart by blanks, text with blanks stands in double quotes, `#` begins a comment.
/// Every method that finds something else than it expects throws std::runtime_error with the word
/// and what is allowed in its place; nothing is remembered of file or line.
class WordReader {
 public:
  explicit WordReader(std::string_view line);

  bool at_end() const { return next_ >= words_.size(); }
  /// The next word, empty at the end.
  std::string_view Peek() const;
  /// Takes the next word if it is `word`.
  bool TakeIf(std::string_view word);
  std::string Take(std::string_view expected);

  /// Index of the next word in `choices`; empty choices are not offered.
  int TakeChoice(std::span<const std::string_view> choices);
  int TakeInteger(int minimum, int maximum);
  double TakeNumber();
  /// "60%" gives 0.6.
  double TakePercent(int minimum, int maximum);
  /// "2.5s" or "200ms".
  Duration TakeDuration();
  /// One or more of M01 .. M22: bit m-1 is motion m.
  uint32_t TakeMotions();
  /// Throws if a word is left.
  void RequireEnd() const;

 private:
  std::vector<std::string> words_;
  size_t next_ = 0;
};

/// "a, b, c" for messages; empty words are left out.
std::string JoinWords(std::span<const std::string_view> words);

}  // namespace eod::box
