#include "dbc/database.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>

namespace eod::dbc {
namespace {

/// Attribute as a number, `fallback` if it is absent or none.
double NumberOf(const std::map<std::string, std::string>& attributes, const char* name,
                double fallback) {
  const auto found = attributes.find(name);
  if (found == attributes.end()) return fallback;
  double value = fallback;
  const std::string& text = found->second;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && std::isfinite(value) ? value : fallback;
}

}  // namespace

int Message::cycle_time_ms() const {
  return static_cast<int>(std::clamp(NumberOf(attributes, "GenMsgCycleTime", 0), 0.0, 3'600'000.0));
}

std::optional<uint16_t> Message::e2e_data_id() const {
  const double value = NumberOf(attributes, "E2EDataId", 0);
  if (value < 1 || value > 0xFFFF) return std::nullopt;
  return static_cast<uint16_t>(value);
}

bool Message::is_fd() const {
  const auto format = attributes.find("VFrameFormat");
  return length > 8 || (format != attributes.end() && format->second.ends_with("_FD"));
}

const Signal* Message::FindSignal(std::string_view signal_name) const {
  const auto found = std::find_if(signals.begin(), signals.end(),
                                  [&](const Signal& signal) { return signal.name == signal_name; });
  return found == signals.end() ? nullptr : &*found;
}

const Message* Database::FindMessage(std::string_view message_name) const {
  const auto found = std::find_if(messages.begin(), messages.end(), [&](const Message& message) {
    return message.name == message_name;
  });
  return found == messages.end() ? nullptr : &*found;
}

const Message* Database::FindMessage(uint32_t id, bool extended) const {
  const auto found = std::find_if(messages.begin(), messages.end(), [&](const Message& message) {
    return message.id == id && message.extended == extended;
  });
  return found == messages.end() ? nullptr : &*found;
}

Database LoadDatabase(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file)) {
    throw std::runtime_error(fmt::format("{}: cannot be read; give a DBC file", file.string()));
  }
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  Database database = ParseDatabase(text, file);
  for (const Diagnostic& diagnostic : database.diagnostics) {
    if (diagnostic.severity != Diagnostic::Severity::kError) continue;
    throw std::runtime_error(fmt::format("{}:{}:{}: {}", file.string(), diagnostic.line,
                                         diagnostic.column, diagnostic.text));
  }
  if (database.messages.empty()) {
    throw std::runtime_error(
        fmt::format("{}:1:1: has no message (BO_); is it a DBC file?", file.string()));
  }
  return database;
}

}  // namespace eod::dbc
