#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "dbc/map_reader.h"
#include "dbc/nearest_name.h"

namespace eod::dbc {
namespace {

/// In place of a signal or message: this box does not have it.
constexpr std::string_view kNone = "none";

std::vector<std::string> Strings(std::span<const std::string_view> names) {
  return {names.begin(), names.end()};
}

}  // namespace

ControlMap MapReader::Read() {
  RefuseUnknownKeys(document_, "the map",
                    {"file", "e2e", "messages", "labels", "controls", "axes", "motions", "displays",
                     "inhibits", "joints", "limits", "lamps", "alarms"});
  ControlMap map;
  map.file = file_;
  ReadFileSection(map);
  ReadMessages(map);
  ReadLabelSets();
  ReadRoles(PanelRoles(), map.controls);
  ReadRoles(FeedbackRoles(), map.displays);
  const toml::table& axes = Section(document_, "axes");
  RefuseUnknownKeys(axes, "[axes]", Strings(AxisNames()));
  for (size_t a = 0; a < map.axes.size(); ++a) {
    map.axes[a] = ReadAxis(axes, std::string(AxisNames()[a]));
  }
  ReadAlarms(map);
  return map;
}

void MapReader::ReadFileSection(ControlMap& map) const {
  const toml::table& file = Section(document_, "file");
  RefuseUnknownKeys(file, "[file]", {"dbc"});
  map.dbc = file_.parent_path() / Text(Required(file, "[file]", "dbc"), "dbc");
  const toml::table& e2e = Section(document_, "e2e");
  RefuseUnknownKeys(e2e, "[e2e]", {"crc", "counter"});
  map.crc_signal = Text(Required(e2e, "[e2e]", "crc"), "crc");
  map.counter_signal = Text(Required(e2e, "[e2e]", "counter"), "counter");
}

void MapReader::ReadMessages(ControlMap& map) const {
  const toml::table& messages = Section(document_, "messages");
  RefuseUnknownKeys(messages, "[messages]", {"box", "robot"});
  const auto read = [&](std::string_view end, std::span<const std::string_view> roles,
                        std::map<std::string, MappedMessage>& mapped) {
    const toml::table& section = Section(messages, end);
    const std::string name = fmt::format("[messages.{}]", end);
    RefuseUnknownKeys(section, name, Strings(roles));
    for (const std::string_view role : roles) {
      const toml::node& node = Required(section, name, role);
      const std::string message = Text(node, role);
      if (message != kNone) mapped[std::string(role)] = {message, LineOf(node)};
    }
  };
  read("box", BoxMessageNames(), map.box_messages);
  read("robot", RobotMessageNames(), map.robot_messages);
}

void MapReader::ReadLabelSets() {
  const toml::table& labels = Section(document_, "labels");
  std::vector<std::string> known;
  for (const Choice* choice : Choices()) known.emplace_back(choice->name);
  RefuseUnknownKeys(labels, "[labels]", known);
  for (const Choice* choice : Choices()) {
    const std::string name{choice->name};
    const toml::node* node = labels.get(name);
    if (node == nullptr) continue;
    if (!node->is_table()) Fail(LineOf(*node), fmt::format("labels.{}: must be a table", name));
    label_sets_[name] = ReadLabels(*node->as_table(), "[labels." + name + "]", *choice);
  }
}

MapReader::Labels MapReader::ReadLabels(const toml::table& table, const std::string& name,
                                        const Choice& choice) const {
  RefuseUnknownKeys(table, name, Strings(choice.values));
  Labels labels;
  for (const std::string_view value : choice.values) {
    const bool may_be_absent =
        value == choice.values[static_cast<size_t>(choice.fallback)] || &choice == &AxisChoice();
    if (may_be_absent && !table.contains(value)) continue;
    labels[std::string(value)] = Text(Required(table, name, value), value);
  }
  return labels;
}

MappedSignal MapReader::ReadSignal(const toml::node& node, const std::string& key,
                                   const Choice* choice, bool is_essential) const {
  MappedSignal mapped;
  mapped.line = LineOf(node);
  const toml::table* table = node.as_table();
  if (table == nullptr) {
    SplitReference(node, key, mapped);
  } else {
    RefuseUnknownKeys(*table, key, {"signal", "inverted", "labels"});
    SplitReference(Required(*table, key, "signal"), key, mapped);
    if (const auto* inverted = table->get("inverted")) {
      mapped.inverted = Flag(*inverted, "inverted");
    }
    const bool is_switch = choice == nullptr || choice == &FlagChoice();
    if (mapped.inverted && !is_switch) {
      Fail(mapped.line, fmt::format("{}: only a switch can be inverted", key));
    }
    if (const auto* labels = table->get("labels")) {
      if (choice == nullptr) Fail(LineOf(*labels), fmt::format("{}: takes no labels", key));
      if (!labels->is_table()) Fail(LineOf(*labels), fmt::format("{}.labels: a table", key));
      mapped.labels = ReadLabels(*labels->as_table(), key + ".labels", *choice);
    }
  }
  if (mapped.message.empty() && is_essential) {
    Fail(mapped.line, fmt::format("{} = \"none\": no box can do without it", key));
  }
  const bool needs_labels = choice != nullptr && choice != &FlagChoice() && !mapped.message.empty();
  if (needs_labels && mapped.labels.empty()) {
    const auto found = label_sets_.find(std::string(choice->name));
    if (found == label_sets_.end()) {
      Fail(mapped.line,
           fmt::format("{}: needs [labels.{}] or labels of its own", key, choice->name));
    }
    mapped.labels = found->second;
  }
  return mapped;
}

void MapReader::SplitReference(const toml::node& node, const std::string& key,
                               MappedSignal& mapped) const {
  const std::string text = Text(node, key);
  mapped.line = LineOf(node);
  if (text == kNone) return;
  const size_t dot = text.find('.');
  if (dot == std::string::npos || dot == 0 || dot + 1 == text.size()) {
    Fail(mapped.line,
         fmt::format("{} = \"{}\", allowed: \"MESSAGE.SIGNAL\" or \"none\"", key, text));
  }
  mapped.message = text.substr(0, dot);
  mapped.signal = text.substr(dot + 1);
}

template <typename State>
void MapReader::ReadRoles(const std::vector<Role<State>>& roles,
                          std::map<std::string, MappedSignal>& signals) const {
  std::map<std::string_view, std::vector<std::string>> keys;
  for (const auto& role : roles) keys[role.section].push_back(role.key);
  for (const auto& [section, known] : keys) {
    RefuseUnknownKeys(Section(document_, section), fmt::format("[{}]", section), known);
  }
  for (const auto& role : roles) {
    if (role.kind == RoleKind::kAxis) continue;
    const toml::table& section = Section(document_, role.section);
    const toml::node& node = Required(section, fmt::format("[{}]", role.section), role.key);
    signals[role.name] = ReadSignal(node, role.key, role.choice, role.essential);
  }
}

AxisMap MapReader::ReadAxis(const toml::table& section, const std::string& key) const {
  const std::string name = "[axes." + key + "]";
  const toml::node& node = Required(section, "[axes]", key);
  if (!node.is_table()) Fail(LineOf(node), fmt::format("{}: must be a table", key));
  const toml::table& table = *node.as_table();
  const auto modes = ControlModeChoice().values.subspan(
      1, static_cast<size_t>(ControlModeChoice().fallback) - 1);  // all but none, not_available
  std::vector<std::string> known = Strings(modes);
  known.insert(known.end(), {"signal", "inverted", "dead_zone"});
  RefuseUnknownKeys(table, name, known);

  AxisMap axis;
  axis.signal = ReadSignal(Required(table, name, "signal"), key, &AxisChoice(), false);
  if (const auto* inverted = table.get("inverted")) {
    axis.signal.inverted = Flag(*inverted, "inverted");
  }
  if (const auto* dead_zone = table.get("dead_zone")) {
    axis.dead_zone = Number(*dead_zone, "dead_zone", 0, 0.5);
  }
  for (const std::string_view mode : modes) {
    const toml::node* pair = table.get(mode);
    if (pair == nullptr) continue;
    if (!pair->is_table()) Fail(LineOf(*pair), fmt::format("{}: must be a table", mode));
    const toml::table& motions = *pair->as_table();
    RefuseUnknownKeys(motions, std::string(mode), {"positive", "negative"});
    AxisMap::Pair mapped;
    mapped.mode = static_cast<ControlMode>(IndexOf(ControlModeChoice().values, mode));
    mapped.positive = ReadMotion(Required(motions, std::string(mode), "positive"), "positive");
    mapped.negative = ReadMotion(Required(motions, std::string(mode), "negative"), "negative");
    axis.motions.push_back(mapped);
  }
  return axis;
}

int MapReader::ReadMotion(const toml::node& node, std::string_view key) const {
  const std::string text = Text(node, key);
  if (text == kNone) return 0;
  for (int motion = 1; motion <= kMotionCount; ++motion) {
    if (text == fmt::format("M{:02}", motion)) return motion;
  }
  Fail(LineOf(node), fmt::format("{} = \"{}\", allowed: M01..M{}, none", key, text, kMotionCount));
}

}  // namespace eod::dbc
