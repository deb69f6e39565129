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
enum class ValueType : uint8_t { kInteger, kFloat, kDouble };  ///< SIG_VALTYPE_ 0, 1, 2

/// Where a signal stands in a multiplexed message.
struct Multiplexing {
  bool is_selector = false;            ///< "M" and "m3M"
  std::optional<int64_t> selected_by;  ///< "m3": the signal is there while its selector is 3
};

/// One SG_ line with what the rest of the file says about it.
struct Signal {
  std::string name;
  int start_bit = 0;  ///< as in the file: Intel = LSB; Motorola = MSB, sawtooth numbering
  int length = 0;     ///< [bit] 1..64
  ByteOrder byte_order = ByteOrder::kIntel;
  bool is_signed = false;
  ValueType value_type = ValueType::kInteger;
  double factor = 1;
  double offset = 0;
  double minimum = 0;  ///< minimum == maximum == 0: no range declared
  double maximum = 0;
  std::string unit;
  std::vector<std::string> receivers;
  std::string comment;
  std::map<int64_t, std::string> labels;          ///< VAL_: raw value to text
  std::map<std::string, std::string> attributes;  ///< BA_ values and BA_DEF_DEF_ defaults, as text
  Multiplexing multiplexing;
  int line = 0;  ///< in the file, 1-based

  bool is_multiplexed() const { return multiplexing.selected_by.has_value(); }
  bool has_range() const { return minimum != 0 || maximum != 0; }
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
  /// E2EDataId attribute; empty if the message has no end-to-end protection (attribute absent or
  /// 0).
  std::optional<uint16_t> e2e_data_id() const;
  /// True if it goes as a CAN FD frame: VFrameFormat says so, or it is longer than 8 bytes.
  bool is_fd() const;
  const Signal* FindSignal(std::string_view signal_name) const;
};

/// Something in the file that is not as it should be.
struct Diagnostic {
  enum class Severity : uint8_t {
    kWarning,  ///< taken, but dubious: an id beyond 11 bits, a signal outside its message
    kError,    ///< could not be taken, and was skipped
  };
  Severity severity = Severity::kError;
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
  std::map<std::string, std::map<int64_t, std::string>> value_tables;  ///< VAL_TABLE_
  std::map<std::string, std::string> attributes;                       ///< of the network
  std::string comment;
  std::vector<Diagnostic> diagnostics;  ///< by line

  const Message* FindMessage(std::string_view message_name) const;
  const Message* FindMessage(uint32_t id, bool extended) const;
};

/// Reads DBC text. Never throws: what it cannot take is reported in `diagnostics` and skipped up to
/// the next section keyword.
Database ParseDatabase(std::string_view text, const std::filesystem::path& file);

/// Reads a DBC file and refuses one with errors. Throws std::runtime_error with one line
/// "FILE:LINE:COLUMN: TEXT" if it cannot be read, has an error, or has no message.
Database LoadDatabase(const std::filesystem::path& file);

}  // namespace eod::dbc
