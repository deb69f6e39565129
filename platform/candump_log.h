#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "platform/can_frame.h"

namespace eod {

/// One line of `candump -L`: `(sec.usec) IFACE ID#DATA`; 8 digits for extended identifiers,
/// `#R[len]` remote, `##<flags>DATA` CAN FD, error frames with 0x20000000 in the identifier.
std::string FormatCandumpLine(const CanFrame& frame, std::string_view interface_name);

/// Inverse of FormatCandumpLine; a trailing direction letter (`T`/`R`) is allowed. Empty if
/// malformed.
std::optional<CanFrame> ParseCandumpLine(std::string_view line);

/// All frames of a log. Throws std::runtime_error "FILE:LINE: …" on the first bad line.
std::vector<CanFrame> ReadCandumpLog(const std::filesystem::path& file);

/// Appends frames to a file. Throws std::runtime_error at opening if the file cannot be written.
class CandumpWriter {
 public:
  CandumpWriter(const std::filesystem::path& file, std::string interface_name);
  void Write(const CanFrame& frame);

 private:
  std::ofstream out_;
  std::string interface_name_;
};

}  // namespace eod
