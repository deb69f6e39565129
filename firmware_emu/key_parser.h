#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace eod::box {

/// One key as a terminal reports it.
struct Key {
  enum class Kind : uint8_t { kCharacter, kUp, kDown, kLeft, kRight, kEnter, kEscape };
  Kind kind = Kind::kCharacter;
  char character = 0;  ///< printable ASCII, of kCharacter only
  bool operator==(const Key&) const = default;
};

/// Turns a terminal's bytes into keys. Understands the arrow keys of xterm and the VT series
/// (ESC [ A, ESC O A, with modifiers ESC [ 1 ; 5 A), swallows other escape sequences, and ignores
/// bytes beyond ASCII. A sequence may come in pieces.
class KeyParser {
 public:
  std::vector<Key> Feed(std::string_view bytes);

  /// Nothing more came for a while: a lone ESC was the Escape key.
  std::vector<Key> Flush();

 private:
  std::string pending_;  ///< begins with ESC, or is empty
};

}  // namespace eod::box
