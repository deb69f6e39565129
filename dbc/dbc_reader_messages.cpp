#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "dbc/dbc_reader.h"

namespace eod::dbc {

using Kind = Token::Kind;
using Severity = Diagnostic::Severity;

namespace {

constexpr uint32_t kExtendedFlag = 0x8000'0000;
constexpr uint32_t kExtendedIds = 0x1FFF'FFFF;
constexpr uint32_t kStandardIds = 0x7FF;
constexpr int kMaxPayload = 64;
/// Name (and id 0xC0000000) of the pseudo-message that keeps the signals of no message.
constexpr std::string_view kOrphans = "VECTOR__INDEPENDENT_SIG_MSG";
constexpr std::string_view kNobody = "Vector__XXX";

}  // namespace

void DbcReader::ReadMessage() {
  drop_signals_ = true;  // until the line turns out to be good
  const Token keyword = Take();
  const int64_t file_id = ExpectInteger("a message id");
  Message message;
  message.line = keyword.line;
  message.name = ExpectWord("a message name");
  ExpectMark(":");
  const Token length_token = Peek();
  const int64_t length = ExpectInteger("a length in bytes");
  if (Peek().kind == Kind::kWord && !AtStatement()) message.sender = Take().text;
  if (message.name == kOrphans) return;
  if (file_id < 0 || file_id > 0xFFFF'FFFF) {
    throw SyntaxError{keyword, fmt::format("message id {} does not fit 32 bits", file_id)};
  }
  if (length < 0 || length > kMaxPayload) {
    throw SyntaxError{length_token, fmt::format("length {} of message {}, allowed 0..{} bytes",
                                                length, message.name, kMaxPayload)};
  }
  const auto id = static_cast<uint32_t>(file_id);
  message.extended = (id & kExtendedFlag) != 0;
  message.id = message.extended ? id & kExtendedIds : id;
  message.length = static_cast<int>(length);
  if (!message.extended && id > kStandardIds) {
    Report(
        Severity::kWarning, keyword,
        fmt::format("message {}: id 0x{:X} has more than 11 bits, yet bit 31 (extended) is not set",
                    message.name, id));
  }
  if (!message_by_file_id_.emplace(id, database_.messages.size()).second) {
    throw SyntaxError{keyword,
                      fmt::format("message {}: id {} is that of {} in line {}", message.name, id,
                                  database_.messages[message_by_file_id_[id]].name,
                                  database_.messages[message_by_file_id_[id]].line)};
  }
  database_.messages.push_back(std::move(message));
  in_message_ = true;
  drop_signals_ = false;
}

void DbcReader::ReadSignal() {
  const Token keyword = Take();
  if (drop_signals_) return SkipToStatement();
  if (!in_message_) throw SyntaxError{keyword, "SG_ without a message (BO_) before it"};
  Message& message = database_.messages.back();
  Signal signal;
  signal.line = keyword.line;
  const Token name = Peek();
  signal.name = ExpectWord("a signal name");
  if (message.FindSignal(signal.name) != nullptr) {
    throw SyntaxError{name,
                      fmt::format("signal {} is twice in message {}", signal.name, message.name)};
  }
  signal.multiplexing = ReadMultiplexing();
  ExpectMark(":");
  ReadLayout(signal);
  ReadScale(signal);
  signal.unit = ExpectString("a unit");
  ReadReceivers(signal);
  CheckLayout(signal, message, name);
  message.signals.push_back(std::move(signal));
}

Multiplexing DbcReader::ReadMultiplexing() {
  Multiplexing multiplexing;
  if (Peek().kind != Kind::kWord) return multiplexing;
  const Token token = Take();
  std::string_view text = token.text;
  if (text.ends_with('M')) {
    multiplexing.is_selector = true;
    text.remove_suffix(1);
  }
  if (text.starts_with('m')) {
    int64_t value = 0;
    const char* end = text.data() + text.size();
    if (std::from_chars(text.data() + 1, end, value).ptr == end && text.size() > 1) {
      multiplexing.selected_by = value;
      return multiplexing;
    }
  }
  if (!text.empty()) {
    throw SyntaxError{token, fmt::format("'{}' is no multiplexor: M, m0, m0M", token.text)};
  }
  return multiplexing;
}

void DbcReader::ReadLayout(Signal& signal) {
  const Token start = Peek();
  const int64_t start_bit = ExpectInteger("a start bit");
  ExpectMark("|");
  const int64_t length = ExpectInteger("a length in bits");
  ExpectMark("@");
  const int64_t order = ExpectInteger("a byte order: 0 Motorola, 1 Intel");
  if (start_bit < 0 || start_bit >= int64_t{8} * kMaxPayload || length < 1 || length > 64 ||
      order < 0 || order > 3) {
    throw SyntaxError{
        start, fmt::format("signal {}: {}|{}@{}: start bit 0..511, length 1..64, order 0 or 1",
                           signal.name, start_bit, length, order)};
  }
  signal.start_bit = static_cast<int>(start_bit);
  signal.length = static_cast<int>(length);
  signal.byte_order = order % 2 == 0 ? ByteOrder::kMotorola : ByteOrder::kIntel;
  // SavvyCAN writes floating-point signals as @2 and @3.
  if (order >= 2) signal.value_type = length == 64 ? ValueType::kDouble : ValueType::kFloat;
  if (TakeMark("-")) {
    signal.is_signed = true;
  } else {
    ExpectMark("+");
  }
}

void DbcReader::ReadScale(Signal& signal) {
  ExpectMark("(");
  const Token factor = Peek();
  signal.factor = ExpectNumber("a factor");
  ExpectMark(",");
  signal.offset = ExpectNumber("an offset");
  ExpectMark(")");
  ExpectMark("[");
  signal.minimum = ExpectNumber("a minimum");
  ExpectMark("|");
  signal.maximum = ExpectNumber("a maximum");
  ExpectMark("]");
  if (signal.factor == 0) {
    Report(Severity::kWarning, factor, fmt::format("signal {}: factor 0", signal.name));
  }
}

void DbcReader::ReadReceivers(Signal& signal) {
  while (TakeMark(",") || (Peek().kind == Kind::kWord && !Peek().starts_line)) {
    if (Peek().kind != Kind::kWord || AtStatement()) continue;
    const std::string_view receiver = Take().text;
    if (receiver != kNobody) signal.receivers.emplace_back(receiver);
  }
}

void DbcReader::CheckLayout(const Signal& signal, const Message& message, const Token& at) {
  const int first_bit =
      signal.byte_order == ByteOrder::kIntel ? signal.start_bit % 8 : 7 - signal.start_bit % 8;
  const int last_byte = signal.start_bit / 8 + (first_bit + signal.length - 1) / 8;
  if (last_byte < message.length) return;
  Report(Severity::kWarning, at,
         fmt::format("signal {} reaches byte {} of message {}, which has {} bytes", signal.name,
                     last_byte, message.name, message.length));
}

}  // namespace eod::dbc
