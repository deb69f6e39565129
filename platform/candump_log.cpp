#include "platform/candump_log.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <iterator>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace eod {
namespace {

constexpr uint32_t kErrorFlag = 0x20000000;
constexpr int kBitRateSwitchFlag = 1;
constexpr int kErrorStateFlag = 2;

/// What is left of a line, taken from the front.
class Rest {
 public:
  explicit Rest(std::string_view text) : text_(text) {}

  bool Skip(char expected) {
    if (text_.empty() || text_.front() != expected) return false;
    text_.remove_prefix(1);
    return true;
  }
  /// Up to and without `end`, which is taken too; empty if there is none.
  std::string_view Until(char end) {
    const size_t position = text_.find(end);
    if (position == std::string_view::npos) return {};
    const std::string_view taken = text_.substr(0, position);
    text_.remove_prefix(position + 1);
    return taken;
  }
  std::optional<uint8_t> HexDigits(size_t count) {
    unsigned value = 0;
    if (text_.size() < count) return {};
    const char* end = text_.data() + count;
    if (std::from_chars(text_.data(), end, value, 16).ptr != end) return {};
    text_.remove_prefix(count);
    return static_cast<uint8_t>(value);
  }
  bool empty() const { return text_.empty(); }

 private:
  std::string_view text_;
};

template <typename Number>
std::optional<Number> ParseWhole(std::string_view text, int base) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number, base);
  if (text.empty() || error != std::errc{} || stop != end) return {};
  return number;
}

/// `sec.fraction` with one to nine digits of fraction.
std::optional<TimePoint> ParseStamp(std::string_view text) {
  const size_t dot = text.find('.');
  if (dot == std::string_view::npos || text.size() - dot - 1 > 9) return {};
  const auto seconds = ParseWhole<int64_t>(text.substr(0, dot), 10);
  auto fraction = ParseWhole<int64_t>(text.substr(dot + 1), 10);
  if (!seconds || !fraction || *seconds < 0 || *fraction < 0) return {};
  for (size_t digits = text.size() - dot - 1; digits < 9; ++digits) *fraction *= 10;
  return TimePoint{std::chrono::seconds{*seconds} + std::chrono::nanoseconds{*fraction}};
}

bool ParseIdentifier(std::string_view text, CanFrame& frame) {
  const auto value = ParseWhole<uint32_t>(text, 16);
  if (!value) return false;
  frame.error = text.size() == 8 && (*value & kErrorFlag) != 0;
  frame.extended = text.size() == 8 && !frame.error;
  frame.id = frame.error ? *value & ~kErrorFlag : *value;
  return text.size() == 3 || text.size() == 8;
}

bool ParseData(Rest& rest, CanFrame& frame) {
  while (!rest.empty()) {
    const auto byte = rest.HexDigits(2);
    if (!byte || frame.length >= frame.data.size()) return false;
    frame.data[frame.length++] = *byte;
  }
  return true;
}

bool ParseContent(Rest& rest, CanFrame& frame) {
  if (rest.Skip('R')) {
    frame.remote = true;
    if (rest.empty()) return true;
    const auto length = rest.HexDigits(1);
    frame.length = length.value_or(0);
    return length.has_value();
  }
  if (rest.Skip('#')) {
    const auto flags = rest.HexDigits(1);
    if (!flags) return false;
    frame.fd = true;
    frame.bit_rate_switch = (*flags & kBitRateSwitchFlag) != 0;
    frame.error_state_indicator = (*flags & kErrorStateFlag) != 0;
  }
  return ParseData(rest, frame);
}

void AppendFrame(fmt::memory_buffer& line, const CanFrame& frame) {
  auto out = std::back_inserter(line);
  if (frame.error) {
    fmt::format_to(out, "{:08X}#", frame.id | kErrorFlag);
  } else {
    fmt::format_to(out, "{:0{}X}#", frame.id, frame.extended ? 8 : 3);
  }
  if (frame.remote) {
    line.push_back('R');
    if (frame.length > 0) fmt::format_to(out, "{:X}", frame.length);
  }
  if (frame.fd) {
    fmt::format_to(out, "#{:X}",
                   (frame.bit_rate_switch ? kBitRateSwitchFlag : 0) |
                       (frame.error_state_indicator ? kErrorStateFlag : 0));
  }
  for (const uint8_t byte : frame.payload()) fmt::format_to(out, "{:02X}", byte);
}

void AppendLine(fmt::memory_buffer& line, const CanFrame& frame, std::string_view interface_name) {
  const int64_t utime = ToUtime(frame.stamp);
  fmt::format_to(std::back_inserter(line), "({:010}.{:06}) {} ", utime / 1000000, utime % 1000000,
                 interface_name);
  AppendFrame(line, frame);
}

}  // namespace

std::string FormatCandumpLine(const CanFrame& frame, std::string_view interface_name) {
  fmt::memory_buffer line;
  AppendLine(line, frame, interface_name);
  return fmt::to_string(line);
}

std::optional<CanFrame> ParseCandumpLine(std::string_view line) {
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
  for (const std::string_view direction : {" T", " R"}) {
    if (line.ends_with(direction)) line.remove_suffix(direction.size());
  }
  Rest rest(line);
  if (!rest.Skip('(')) return {};
  CanFrame frame;
  const auto stamp = ParseStamp(rest.Until(')'));
  if (!stamp || !rest.Skip(' ') || rest.Until(' ').empty()) return {};
  frame.stamp = *stamp;
  if (!ParseIdentifier(rest.Until('#'), frame) || !ParseContent(rest, frame) || !rest.empty()) {
    return {};
  }
  if (!IsWellFormed(frame)) return {};
  return frame;
}

std::vector<CanFrame> ReadCandumpLog(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(fmt::format("{}: {}", file.string(), std::strerror(errno)));
  std::vector<CanFrame> frames;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.find_first_not_of(" \r\t") == std::string::npos) continue;
    const auto frame = ParseCandumpLine(line);
    if (!frame) {
      throw std::runtime_error(
          fmt::format("{}:{}: '{}' is no line of candump -L, such as (12.345678) can0 123#1122",
                      file.string(), number, line));
    }
    frames.push_back(*frame);
  }
  return frames;
}

CandumpWriter::CandumpWriter(const std::filesystem::path& file, std::string interface_name)
    : out_(file), interface_name_(std::move(interface_name)) {
  if (!out_) {
    throw std::runtime_error(
        fmt::format("{}: cannot be written: {}", file.string(), std::strerror(errno)));
  }
}

void CandumpWriter::Write(const CanFrame& frame) {
  fmt::memory_buffer line;
  AppendLine(line, frame, interface_name_);
  line.push_back('\n');
  out_.write(line.data(), static_cast<std::streamsize>(line.size()));
}

}  // namespace eod
