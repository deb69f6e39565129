#include "dbc/map_reader.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dbc/nearest_name.h"

namespace eod::dbc {

MapReader::MapReader(const std::filesystem::path& file, const toml::table& document)
    : file_(file), document_(document) {}

void MapReader::Fail(int line, const std::string& text) const {
  throw std::runtime_error(fmt::format("{}:{}: {}", file_.string(), line, text));
}

int MapReader::LineOf(const toml::node& node) const {
  return static_cast<int>(node.source().begin.line);
}

const toml::table& MapReader::Section(const toml::table& parent, std::string_view key) const {
  const toml::node* node = parent.get(key);
  if (node == nullptr) Fail(std::max(1, LineOf(parent)), fmt::format("table [{}] is missing", key));
  if (!node->is_table()) Fail(LineOf(*node), fmt::format("{}: must be a table", key));
  return *node->as_table();
}

void MapReader::RefuseUnknownKeys(const toml::table& table, const std::string& name,
                                  const std::vector<std::string>& known) const {
  // The first one in the file, not in the alphabet.
  const toml::key* unknown = nullptr;
  for (const auto& [key, node] : table) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    const bool is_earlier =
        unknown == nullptr || key.source().begin.line < unknown->source().begin.line;
    if (is_earlier) unknown = &key;
  }
  if (unknown == nullptr) return;
  const std::string nearest = NearestName(unknown->str(), known);
  const std::string remedy =
      nearest.empty() ? "no key is known here" : fmt::format("did you mean \"{}\"?", nearest);
  Fail(static_cast<int>(unknown->source().begin.line),
       fmt::format("{}: unknown key \"{}\"; {}", name, unknown->str(), remedy));
}

const toml::node& MapReader::Required(const toml::table& table, const std::string& name,
                                      std::string_view key) const {
  const toml::node* node = table.get(key);
  if (node == nullptr) {
    Fail(std::max(1, LineOf(table)), fmt::format("{}: \"{}\" is missing", name, key));
  }
  return *node;
}

std::string MapReader::Text(const toml::node& node, std::string_view key) const {
  const auto text = node.value_exact<std::string>();
  if (!text) Fail(LineOf(node), fmt::format("{}: must be a text in quotes", key));
  return *text;
}

double MapReader::Number(const toml::node& node, std::string_view key, double low,
                         double high) const {
  const auto number = node.is_number() ? node.value<double>() : std::nullopt;
  if (!number) Fail(LineOf(node), fmt::format("{}: must be a number {}..{}", key, low, high));
  if (!(*number >= low && *number <= high)) {
    Fail(LineOf(node), fmt::format("{} = {}, allowed {}..{}", key, *number, low, high));
  }
  return *number;
}

bool MapReader::Flag(const toml::node& node, std::string_view key) const {
  const auto flag = node.value_exact<bool>();
  if (!flag) Fail(LineOf(node), fmt::format("{}: must be true or false", key));
  return *flag;
}

int MapReader::OneOf(const toml::node& node, std::string_view key,
                     std::span<const std::string_view> allowed) const {
  const std::string text = Text(node, key);
  const int index = IndexOf(allowed, text);
  if (index < 0) {
    Fail(LineOf(node),
         fmt::format("{} = \"{}\", allowed: {}", key, text, fmt::join(allowed, ", ")));
  }
  return index;
}

ControlMap LoadControlMap(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) {
    throw std::runtime_error(
        fmt::format("{}:1: cannot be read; give a control map (*.map.toml)", file.string()));
  }
  try {
    const toml::table document = toml::parse_file(file.string());
    return MapReader(file, document).Read();
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(
        fmt::format("{}:{}: {}", file.string(), error.source().begin.line, error.description()));
  }
}

}  // namespace eod::dbc
