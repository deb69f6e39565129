#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eod::dbc {

enum class ByteOrder : uint8_t { kIntel, kMotorola };

/// One SG_ line with what the rest of the file says about it.
struct Signal {
  std::string name;
  int start_bit = 0;  ///< as in the file: Intel = LSB; Motorola = MSB, sawtooth numbering
  int length = 0;     ///< [bit] 1..64
  ByteOrder byte_order = ByteOrder::kIntel;
  bool is_signed = false;
  double factor = 1;
  double offset = 0;
  double minimum = 0;  ///< minimum == maximum == 0: no range declared
  double maximum = 0;
  std::string unit;
  std::vector<std::string> receivers;
  std::string comment;
  std::map<int64_t, std::string> labels;  ///< VAL_: raw value to text
  int line = 0;                           ///< in the file, 1-based
};

/// One BO_ line with its signals.
struct Message {
  uint32_t id = 0;  ///< without the extended flag (bit 31 of the file)
  bool extended = false;
  std::string name;
  int length = 0;  ///< [byte]
  std::string sender;
  std::string comment;
  std::vector<Signal> signals;
  std::map<std::string, std::string> attributes;  ///< BA_ values and BA_DEF_DEF_ defaults, as text
  int line = 0;

  /// GenMsgCycleTime in milliseconds, 0 if it is sent on events only.
  int cycle_time_ms() const;
  /// E2EDataId attribute; empty if the message has no end-to-end protection.
  std::optional<uint16_t> e2e_data_id() const;
  const Signal* FindSignal(std::string_view signal_name) const;
};

/// Something the reader could not take, and skipped.
struct Diagnostic {
  int line = 0;
  int column = 0;
  std::string text;
};

/// A DBC file.
struct Database {
  std::filesystem::path file;
  std::string version;
  std::vector<std::string> nodes;
  std::vector<Message> messages;
  std::vector<Diagnostic> diagnostics;

  const Message* FindMessage(std::string_view message_name) const;
  const Message* FindMessage(uint32_t id, bool extended) const;
};

/// Reads DBC text. Never throws: what it cannot take is reported in `diagnostics` and skipped up to
/// the next section keyword.
Database ParseDatabase(std::string_view text, const std::filesystem::path& file);

/// Reads a DBC file and refuses one with diagnostics. Throws std::runtime_error with one line
/// "FILE:LINE:COLUMN: TEXT" if it cannot be read, has diagnostics, or has no message.
Database LoadDatabase(const std::filesystem::path& file);

}  // namespace eod::dbc
