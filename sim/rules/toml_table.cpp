#include "sim/rules/toml_table.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

namespace eod::sim {
namespace {

/// Fewest insertions, deletions and replacements that make `a` of `b`.
size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 0; i < a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i + 1;
    for (size_t j = 0; j < b.size(); ++j) {
      const size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

toml::table ParseToml(const std::filesystem::path& file, std::string_view kind) {
  if (!std::filesystem::is_regular_file(file)) {
    throw std::runtime_error(fmt::format("{}: no such {} file", file.string(), kind));
  }
  try {
    return toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(
        fmt::format("{}:{}: {}", file.string(), error.source().begin.line, error.description()));
  }
}

std::string_view NearestName(std::string_view name, std::span<const std::string_view> known) {
  return *std::min_element(known.begin(), known.end(), [name](const auto& a, const auto& b) {
    return EditDistance(name, a) < EditDistance(name, b);
  });
}

void TomlTable::Fail(unsigned line, const std::string& what) const {
  throw std::runtime_error(fmt::format("{}:{}: {}", file_.string(), line, what));
}

void TomlTable::RejectUnknownKeys(std::span<const std::string_view> known) const {
  for (const auto& [key, node] : table_) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    Fail(key.source().begin.line, fmt::format("unknown key '{}'; did you mean '{}'?", key.str(),
                                              NearestName(key.str(), known)));
  }
}

unsigned TomlTable::LineOf(std::string_view key) const {
  const toml::node* node = table_.get(key);
  return node == nullptr ? line() : node->source().begin.line;
}

std::string TomlTable::Text(std::string_view key, std::optional<std::string> fallback) const {
  return Value<std::string>(key, "text", std::move(fallback));
}

double TomlTable::Number(std::string_view key, double low, double high,
                         std::optional<double> fallback) const {
  if (!Has(key) && fallback) return *fallback;
  const double value = Value<double>(key, "a number", fallback);
  if (!(value >= low && value <= high)) {
    Fail(LineOf(key), fmt::format("{} = {}, allowed {} .. {}", key, value, low, high));
  }
  return value;
}

int64_t TomlTable::Integer(std::string_view key, int64_t low, int64_t high,
                           std::optional<int64_t> fallback) const {
  if (!Has(key) && fallback) return *fallback;
  const int64_t value = Value<int64_t>(key, "a whole number", fallback);
  if (value < low || value > high) {
    Fail(LineOf(key), fmt::format("{} = {}, allowed {} .. {}", key, value, low, high));
  }
  return value;
}

bool TomlTable::Flag(std::string_view key, std::optional<bool> fallback) const {
  return Value<bool>(key, "true or false", fallback);
}

std::vector<double> TomlTable::Numbers(std::string_view key, size_t count, double low,
                                       double high) const {
  std::vector<double> numbers;
  const toml::node* node = table_.get(key);
  if (node == nullptr) return numbers;
  const toml::array* list = node->as_array();
  const auto is_good = [low, high](const toml::node& one) {
    const std::optional<double> value = one.value<double>();
    return value && *value >= low && *value <= high;
  };
  if (list == nullptr || list->size() != count ||
      !std::all_of(list->begin(), list->end(), is_good)) {
    Fail(LineOf(key),
         fmt::format("'{}' has to be a list of {} numbers within {} .. {}", key, count, low, high));
  }
  for (const toml::node& one : *list) numbers.push_back(*one.value<double>());
  return numbers;
}

std::vector<std::string> TomlTable::Texts(std::string_view key) const {
  std::vector<std::string> texts;
  const toml::node* node = table_.get(key);
  if (node == nullptr) return texts;
  const toml::array* list = node->as_array();
  const bool is_good =
      list != nullptr &&
      std::all_of(list->begin(), list->end(), [](const auto& one) { return one.is_string(); });
  if (!is_good) Fail(LineOf(key), fmt::format("'{}' has to be a list of texts", key));
  for (const toml::node& one : *list) texts.push_back(*one.value<std::string>());
  return texts;
}

std::vector<std::array<double, 2>> TomlTable::Points(std::string_view key, double low,
                                                     double high) const {
  std::vector<std::array<double, 2>> points;
  const toml::node* node = table_.get(key);
  if (node == nullptr) return points;
  const auto refuse = [&] {
    Fail(LineOf(key),
         fmt::format("'{}' has to be a list of points [x, y] within {} .. {}", key, low, high));
  };
  const toml::array* list = node->as_array();
  if (list == nullptr) refuse();
  for (const toml::node& one : *list) {
    const toml::array* pair = one.as_array();
    if (pair == nullptr || pair->size() != 2) refuse();
    const std::optional<double> x = (*pair)[0].value<double>(), y = (*pair)[1].value<double>();
    if (!x || !y || *x < low || *x > high || *y < low || *y > high) refuse();
    points.push_back({*x, *y});
  }
  return points;
}

size_t TomlTable::Choice(std::string_view key, std::span<const std::string_view> names,
                         std::optional<size_t> fallback) const {
  if (!Has(key) && fallback) return *fallback;
  const std::string name = Text(key);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    Fail(LineOf(key), fmt::format("{} = '{}' is unknown; did you mean '{}'?", key, name,
                                  NearestName(name, names)));
  }
  return static_cast<size_t>(found - names.begin());
}

std::vector<size_t> TomlTable::Choices(std::string_view key,
                                       std::span<const std::string_view> names) const {
  std::vector<size_t> choices;
  const toml::node* node = table_.get(key);
  if (node == nullptr) return choices;
  const toml::array* list = node->as_array();
  if (list == nullptr) Fail(LineOf(key), fmt::format("'{}' has to be a list of texts", key));
  for (const toml::node& one : *list) {
    const std::optional<std::string> name = one.value<std::string>();
    if (!name) Fail(one.source().begin.line, fmt::format("'{}' has to be a list of texts", key));
    const auto found = std::find(names.begin(), names.end(), *name);
    if (found == names.end()) {
      Fail(one.source().begin.line, fmt::format("{}: '{}' is unknown; did you mean '{}'?", key,
                                                *name, NearestName(*name, names)));
    }
    choices.push_back(static_cast<size_t>(found - names.begin()));
  }
  return choices;
}

std::vector<Eigen::Vector2d> TomlTable::Points(std::string_view key, size_t least, double low,
                                               double high) const {
  std::vector<Eigen::Vector2d> points;
  const toml::node* node = table_.get(key);
  if (node == nullptr) Fail(line(), fmt::format("key '{}' is missing", key));
  const toml::array* list = node->as_array();
  const auto fail = [&](unsigned line) {
    Fail(line, fmt::format("'{}' has to be a list of at least {} points [x, y] within {} .. {}",
                           key, least, low, high));
  };
  if (list == nullptr || list->size() < least) fail(LineOf(key));
  for (const toml::node& one : *list) {
    const toml::array* pair = one.as_array();
    if (pair == nullptr || pair->size() != 2) fail(one.source().begin.line);
    Eigen::Vector2d& point = points.emplace_back();
    for (size_t axis = 0; axis < 2; ++axis) {
      const std::optional<double> value = pair->get(axis)->value<double>();
      if (!value || !(*value >= low && *value <= high)) fail(one.source().begin.line);
      point[static_cast<Eigen::Index>(axis)] = *value;
    }
  }
  return points;
}

TomlTable TomlTable::Table(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) Fail(line(), fmt::format("table [{}] is missing", key));
  if (!node->is_table()) Fail(LineOf(key), fmt::format("'{}' has to be a table: [{}]", key, key));
  return {file_, *node->as_table()};
}

std::vector<TomlTable> TomlTable::Tables(std::string_view key) const {
  std::vector<TomlTable> tables;
  const toml::node* node = table_.get(key);
  if (node == nullptr) return tables;
  if (!node->is_array_of_tables()) {
    Fail(LineOf(key), fmt::format("'{}' has to be a list of tables: [[{}]]", key, key));
  }
  for (const toml::node& one : *node->as_array()) tables.emplace_back(file_, *one.as_table());
  return tables;
}

template <typename T>
T TomlTable::Value(std::string_view key, std::string_view type, std::optional<T> fallback) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) {
    if (fallback) return *std::move(fallback);
    Fail(line(), fmt::format("key '{}' is missing", key));
  }
  const std::optional<T> value = node->value<T>();
  if (!value) Fail(LineOf(key), fmt::format("'{}' has to be {}", key, type));
  return *value;
}

}  // namespace eod::sim
