#include "firmware_emu/key_parser.h"

#include <optional>

namespace eod::box {
namespace {

constexpr char kEscape = '\x1b';
constexpr size_t kLongestSequence = 16;  // anything longer is no key

// ECMA-48: a control sequence ends with a byte in 0x40..0x7E.
bool IsFinal(char byte) { return byte >= 0x40 && byte <= 0x7e; }

std::optional<Key> ArrowKey(char final) {
  switch (final) {
    case 'A':
      return Key{.kind = Key::Kind::kUp};
    case 'B':
      return Key{.kind = Key::Kind::kDown};
    case 'C':
      return Key{.kind = Key::Kind::kRight};
    case 'D':
      return Key{.kind = Key::Kind::kLeft};
    default:
      return std::nullopt;
  }
}

std::optional<Key> PlainKey(char byte) {
  if (byte == '\r' || byte == '\n') return Key{.kind = Key::Kind::kEnter};
  if (byte >= ' ' && byte <= '~') return Key{.kind = Key::Kind::kCharacter, .character = byte};
  return std::nullopt;
}

bool IsIntroducer(char byte) { return byte == '[' || byte == 'O'; }

}  // namespace

std::vector<Key> KeyParser::Feed(std::string_view bytes) {
  std::vector<Key> keys;
  const auto add = [&keys](const std::optional<Key>& key) {
    if (key) keys.push_back(*key);
  };
  for (const char byte : bytes) {
    if (pending_.empty()) {
      if (byte == kEscape) {
        pending_ = byte;
      } else {
        add(PlainKey(byte));
      }
    } else if (pending_.size() == 1 && !IsIntroducer(byte)) {
      // ESC before something else: the Escape key, then that.
      keys.push_back({.kind = Key::Kind::kEscape});
      pending_.clear();
      if (byte == kEscape) {
        pending_ = byte;
      } else {
        add(PlainKey(byte));
      }
    } else {
      pending_ += byte;
      const bool is_complete = pending_.size() > 2 && IsFinal(byte);
      if (is_complete) add(ArrowKey(byte));
      if (is_complete || pending_.size() > kLongestSequence) pending_.clear();
    }
  }
  return keys;
}

std::vector<Key> KeyParser::Flush() {
  const bool is_lone_escape = pending_.size() == 1;
  pending_.clear();
  if (!is_lone_escape) return {};
  return {{.kind = Key::Kind::kEscape}};
}

}  // namespace eod::box
