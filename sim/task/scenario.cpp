#include "sim/task/scenario.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>
#include <toml++/toml.h>

namespace eod::sim {
namespace {

constexpr std::array<std::string_view, 7> kScenarioKeys = {
    "name", "title", "module", "par_time_s", "time_limit_s", "seed", "step"};
constexpr std::array<std::string_view, 8> kStepKeys = {
    "kind", "object", "distance_m", "tolerance_m", "x_m", "y_m", "text", "weight"};

struct KindName {
  std::string_view name;
  TaskStep::Kind kind;
};
constexpr std::array kKinds = {
    KindName{"contact", TaskStep::Kind::kContact}, KindName{"clear", TaskStep::Kind::kClear},
    KindName{"pass_gate", TaskStep::Kind::kPassGate}, KindName{"stop_at", TaskStep::Kind::kStopAt},
    KindName{"reach", TaskStep::Kind::kReach}};

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

std::string_view Nearest(std::string_view key, std::span<const std::string_view> known) {
  return *std::min_element(known.begin(), known.end(), [key](const auto& a, const auto& b) {
    return EditDistance(key, a) < EditDistance(key, b);
  });
}

/// A TOML table with the words for its errors.
class TableReader {
 public:
  TableReader(const std::filesystem::path& file, const toml::table& table)
      : file_(file), table_(table) {}

  [[noreturn]] void Fail(unsigned line, const std::string& what) const {
    throw std::runtime_error(fmt::format("{}:{}: {}", file_.string(), line, what));
  }

  void RejectUnknownKeys(std::span<const std::string_view> known) const {
    for (const auto& [key, node] : table_) {
      if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
      Fail(key.source().begin.line, fmt::format("unknown key '{}'; did you mean '{}'?", key.str(),
                                                Nearest(key.str(), known)));
    }
  }

  unsigned line() const { return std::max(1U, table_.source().begin.line); }
  unsigned LineOf(std::string_view key) const {
    const toml::node* node = table_.get(key);
    return node == nullptr ? line() : node->source().begin.line;
  }

  std::string Text(std::string_view key, std::optional<std::string> fallback = {}) const {
    return Value<std::string>(key, "text", std::move(fallback));
  }

  double Number(std::string_view key, double low, double high,
                std::optional<double> fallback = {}) const {
    const double value = Value<double>(key, "a number", fallback);
    if (!(value >= low && value <= high)) {
      Fail(LineOf(key), fmt::format("{} = {}, allowed {} .. {}", key, value, low, high));
    }
    return value;
  }

  int64_t Integer(std::string_view key, int64_t low, int64_t high,
                  std::optional<int64_t> fallback = {}) const {
    const int64_t value = Value<int64_t>(key, "a whole number", fallback);
    if (value < low || value > high) {
      Fail(LineOf(key), fmt::format("{} = {}, allowed {} .. {}", key, value, low, high));
    }
    return value;
  }

 private:
  template <typename T>
  T Value(std::string_view key, std::string_view type, std::optional<T> fallback) const {
    const toml::node* node = table_.get(key);
    if (node == nullptr) {
      if (fallback) return *std::move(fallback);
      Fail(line(), fmt::format("key '{}' is missing", key));
    }
    const std::optional<T> value = node->value<T>();
    if (!value) Fail(LineOf(key), fmt::format("'{}' has to be {}", key, type));
    return *value;
  }

  const std::filesystem::path& file_;
  const toml::table& table_;
};

constexpr double kMaxLength = 3000;  // [m] the whole world
constexpr double kMaxTime = 86400;   // [s]

TaskStep::Kind ReadKind(const TableReader& reader) {
  const std::string name = reader.Text("kind");
  std::array<std::string_view, kKinds.size()> names;
  for (size_t i = 0; i < kKinds.size(); ++i) {
    if (kKinds[i].name == name) return kKinds[i].kind;
    names[i] = kKinds[i].name;
  }
  reader.Fail(reader.LineOf("kind"), fmt::format("kind = '{}' is unknown; did you mean '{}'?", name,
                                                 Nearest(name, names)));
}

TaskStep ReadStep(const TableReader& reader) {
  reader.RejectUnknownKeys(kStepKeys);
  TaskStep step;
  step.kind = ReadKind(reader);
  step.text = reader.Text("text");
  step.weight = reader.Number("weight", 0, 100, 1.0);
  const bool names_object =
      step.kind == TaskStep::Kind::kPassGate || step.kind == TaskStep::Kind::kStopAt;
  step.object = names_object ? reader.Text("object") : reader.Text("object", "");
  if (names_object || step.kind == TaskStep::Kind::kClear) {
    step.distance = reader.Number("distance_m", 0, kMaxLength);
  }
  if (step.kind == TaskStep::Kind::kStopAt || step.kind == TaskStep::Kind::kReach) {
    step.tolerance = reader.Number("tolerance_m", 0, kMaxLength);
  }
  if (step.kind == TaskStep::Kind::kReach) {
    step.x = reader.Number("x_m", -kMaxLength, kMaxLength);
    step.y = reader.Number("y_m", -kMaxLength, kMaxLength);
  }
  return step;
}

toml::table Parse(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) {
    throw std::runtime_error(fmt::format("{}: no such scenario file", file.string()));
  }
  try {
    return toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(
        fmt::format("{}:{}: {}", file.string(), error.source().begin.line, error.description()));
  }
}

}  // namespace

Scenario LoadScenario(const std::filesystem::path& file) {
  const toml::table table = Parse(file);
  const TableReader reader(file, table);
  reader.RejectUnknownKeys(kScenarioKeys);
  Scenario scenario;
  scenario.file = file;
  scenario.name = reader.Text("name");
  scenario.title = reader.Text("title", "");
  scenario.module = static_cast<int>(reader.Integer("module", 1, 5));
  scenario.par_time_s = reader.Number("par_time_s", 0, kMaxTime, 0.0);
  scenario.time_limit_s = reader.Number("time_limit_s", 0, kMaxTime, 0.0);
  scenario.seed = reader.Integer("seed", INT64_MIN, INT64_MAX, 0);

  const toml::node* steps = table.get("step");
  if (steps == nullptr) return scenario;
  if (!steps->is_array_of_tables()) {
    reader.Fail(reader.LineOf("step"), "'step' has to be a list of tables: [[step]]");
  }
  for (const toml::node& step : *steps->as_array()) {
    scenario.steps.push_back(ReadStep(TableReader(file, *step.as_table())));
  }
  return scenario;
}

}  // namespace eod::sim
