#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <toml++/toml.h>

namespace eod::sim {

/// Parses a TOML file; `kind` says what it should be, as in "no such scenario file". Throws
/// std::runtime_error with one line "FILE:LINE: …".
toml::table ParseToml(const std::filesystem::path& file, std::string_view kind);

/// The name among `known` that `name` was probably meant to be.
std::string_view NearestName(std::string_view name, std::span<const std::string_view> known);

/// A TOML table with the words for its errors: all throw std::runtime_error "FILE:LINE: …".
class TomlTable {
 public:
  /// Both must outlive the reader.
  TomlTable(const std::filesystem::path& file, const toml::table& table)
      : file_(file), table_(table) {}

  [[noreturn]] void Fail(unsigned line, const std::string& what) const;
  void RejectUnknownKeys(std::span<const std::string_view> known) const;

  unsigned line() const { return std::max(1U, table_.source().begin.line); }
  unsigned LineOf(std::string_view key) const;

  std::string Text(std::string_view key, std::optional<std::string> fallback = {}) const;
  /// Allowed is low .. high, both included.
  double Number(std::string_view key, double low, double high,
                std::optional<double> fallback = {}) const;
  int64_t Integer(std::string_view key, int64_t low, int64_t high,
                  std::optional<int64_t> fallback = {}) const;
  bool Flag(std::string_view key, std::optional<bool> fallback = {}) const;
  /// Numbers in a list, `count` of them, each within low .. high; empty if the key is missing.
  std::vector<double> Numbers(std::string_view key, size_t count, double low, double high) const;
  /// Texts in a list; none if the key is missing.
  std::vector<std::string> Texts(std::string_view key) const;
  /// Points [[x, y], ...] with coordinates within low .. high; none if the key is missing.
  std::vector<std::array<double, 2>> Points(std::string_view key, double low, double high) const;
  /// Index of the text among `names`; the error names the nearest one.
  size_t Choice(std::string_view key, std::span<const std::string_view> names,
                std::optional<size_t> fallback = {}) const;
  /// Indices of the texts of a list; empty if the key is missing.
  std::vector<size_t> Choices(std::string_view key, std::span<const std::string_view> names) const;
  /// Points of a list of [x, y], at least `least`, each number within low .. high.
  std::vector<Eigen::Vector2d> Points(std::string_view key, size_t least, double low,
                                      double high) const;

  bool Has(std::string_view key) const { return table_.contains(key); }
  /// A table of that name, which has to be there.
  TomlTable Table(std::string_view key) const;
  /// The tables of the list [[key]], none if it is missing.
  std::vector<TomlTable> Tables(std::string_view key) const;

 private:
  template <typename T>
  T Value(std::string_view key, std::string_view type, std::optional<T> fallback) const;

  const std::filesystem::path& file_;
  const toml::table& table_;
};

}  // namespace eod::sim
