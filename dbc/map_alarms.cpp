#include <algorithm>

#include <fmt/format.h>

#include "dbc/map_reader.h"

namespace eod::dbc {

void MapReader::ReadAlarms(ControlMap& map) const {
  for (const auto& [name, node] : Section(document_, "alarms")) {
    map.alarms.push_back(ReadAlarm(std::string(name.str()), node));
  }
  const auto by_code = [](const AlarmMap& a, const AlarmMap& b) { return a.code < b.code; };
  std::sort(map.alarms.begin(), map.alarms.end(), by_code);
  const auto twice =
      std::adjacent_find(map.alarms.begin(), map.alarms.end(),
                         [](const AlarmMap& a, const AlarmMap& b) { return a.code == b.code; });
  if (twice != map.alarms.end()) {
    Fail(LineOf(*document_["alarms"][twice->name].node()),
         fmt::format("alarms {} and {} have the same code 0x{:02X}", twice->name, (twice + 1)->name,
                     twice->code));
  }
}

AlarmMap MapReader::ReadAlarm(const std::string& name, const toml::node& node) const {
  const std::string title = "[alarms." + name + "]";
  if (!node.is_table()) Fail(LineOf(node), fmt::format("alarms.{}: must be a table", name));
  const toml::table& table = *node.as_table();
  RefuseUnknownKeys(table, title, {"code", "lamp", "pattern", "buzzer", "priority"});
  AlarmMap alarm;
  alarm.name = name;
  alarm.code = static_cast<int>(Number(Required(table, title, "code"), "code", 1, 255));
  alarm.priority =
      static_cast<int>(Number(Required(table, title, "priority"), "priority", 0, 1000));
  alarm.buzzer = static_cast<BuzzerPattern>(
      OneOf(Required(table, title, "buzzer"), "buzzer", BuzzerChoice().values));
  const toml::node& lamp = Required(table, title, "lamp");
  if (lamp.value<std::string>() == "none") return alarm;
  alarm.lamp = static_cast<Lamp>(OneOf(lamp, "lamp", LampChoice().values));
  alarm.pattern = static_cast<LampPattern>(
      OneOf(Required(table, title, "pattern"), "pattern", LampPatternChoice().values));
  return alarm;
}

}  // namespace eod::dbc
