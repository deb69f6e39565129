#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "dbc/control_map.h"
#include "dbc/roles.h"

namespace eod::dbc {

/// Reads one parsed map file into a ControlMap. Every error is a std::runtime_error
/// "FILE:LINE: WHAT: what is allowed".
class MapReader {
 public:
  /// `document` must outlive the reader.
  MapReader(const std::filesystem::path& file, const toml::table& document);

  ControlMap Read();

 private:
  using Labels = std::map<std::string, std::string>;

  // Tables and values (map_reader.cpp).
  [[noreturn]] void Fail(int line, const std::string& text) const;
  int LineOf(const toml::node& node) const;
  const toml::table& Section(const toml::table& parent, std::string_view key) const;
  /// Fails on the first key of `table` that is not `known`.
  void RefuseUnknownKeys(const toml::table& table, const std::string& name,
                         const std::vector<std::string>& known) const;
  const toml::node& Required(const toml::table& table, const std::string& name,
                             std::string_view key) const;
  std::string Text(const toml::node& node, std::string_view key) const;
  double Number(const toml::node& node, std::string_view key, double low, double high) const;
  bool Flag(const toml::node& node, std::string_view key) const;
  int OneOf(const toml::node& node, std::string_view key,
            std::span<const std::string_view> allowed) const;

  // The map's sections (map_sections.cpp).
  void ReadFileSection(ControlMap& map) const;
  void ReadMessages(ControlMap& map) const;
  void ReadLabelSets();
  Labels ReadLabels(const toml::table& table, const std::string& name, const Choice& choice) const;
  MappedSignal ReadSignal(const toml::node& node, const std::string& key, const Choice* choice,
                          bool is_essential) const;
  void SplitReference(const toml::node& node, const std::string& key, MappedSignal& mapped) const;
  template <typename State>
  void ReadRoles(const std::vector<Role<State>>& roles,
                 std::map<std::string, MappedSignal>& signals) const;
  AxisMap ReadAxis(const toml::table& section, const std::string& key) const;
  int ReadMotion(const toml::node& node, std::string_view key) const;
  void ReadAlarms(ControlMap& map) const;
  AlarmMap ReadAlarm(const std::string& name, const toml::node& node) const;

  std::filesystem::path file_;
  const toml::table& document_;
  std::map<std::string, Labels> label_sets_;
};

}  // namespace eod::dbc
