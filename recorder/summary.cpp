#include "recorder/summary.h"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace eod::recorder {
namespace {

using Json = nlohmann::ordered_json;

// Three decimals are microseconds and millimetres; more would be noise in a file that people read.
double Rounded(double value) { return std::round(value * 1e3) / 1e3; }

Json ToJson(const Percentiles& percentiles) {
  Json json = {{"p50", nullptr}, {"p99", nullptr}, {"n", percentiles.n}};
  if (percentiles.p50) json["p50"] = Rounded(*percentiles.p50);
  if (percentiles.p99) json["p99"] = Rounded(*percentiles.p99);
  return json;
}

std::string ToText(const Percentiles& percentiles) {
  if (!percentiles.p50) return "no sample";
  return fmt::format("p50 {:.2f} ms, p99 {:.2f} ms, n {}", *percentiles.p50, *percentiles.p99,
                     percentiles.n);
}

}  // namespace

std::string ToJson(const Summary& summary) {
  Json alarms = Json::array();
  for (const RaisedAlarm& alarm : summary.alarms) {
    alarms.push_back({{"t", Rounded(alarm.t)}, {"code", alarm.code}, {"parts", alarm.parts}});
  }
  const Json json = {
      {"bus", summary.bus},
      {"module", summary.module},
      {"result", summary.result},
      {"sim_seconds", Rounded(summary.sim_seconds)},
      {"alarms", alarms},
      {"can",
       {{"rx", summary.can.rx},
        {"tx", summary.can.tx},
        {"lost", summary.can.lost},
        {"crc_errors", summary.can.crc_errors},
        {"bus_load_percent", Rounded(summary.can.bus_load_percent)}}},
      {"camera",
       {{"frames", summary.camera.frames},
        {"fps", Rounded(summary.camera.fps)},
        {"width", summary.camera.width},
        {"height", summary.camera.height}}},
      {"latency_ms",
       {{"button_to_pose", ToJson(summary.latency_ms.button_to_pose)},
        {"contact_to_lamp_frame", ToJson(summary.latency_ms.contact_to_lamp_frame)}}},
      {"step",
       {{"period_ms", Rounded(summary.step.period_ms)}, {"overruns", summary.step.overruns}}},
  };
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string ToText(const Summary& summary) {
  std::string text = fmt::format("result           {}, module {}, {:.1f} s simulated on {}\n",
                                 summary.result, summary.module, summary.sim_seconds, summary.bus);
  if (summary.alarms.empty()) text += "alarms           none\n";
  std::string_view heading = "alarms";
  for (const RaisedAlarm& alarm : summary.alarms) {
    const std::string parts = PartNames(alarm.parts);
    text += fmt::format("{:<16} {:7.2f} s  {}{}{}\n", std::exchange(heading, ""), alarm.t,
                        AlarmName(alarm.code), parts.empty() ? "" : ": ", parts);
  }
  text += fmt::format("button to pose   {}\n", ToText(summary.latency_ms.button_to_pose));
  text += fmt::format("contact to lamp  {}\n", ToText(summary.latency_ms.contact_to_lamp_frame));
  text +=
      fmt::format("camera           {} pictures {}x{}, {:.1f} a second\n", summary.camera.frames,
                  summary.camera.width, summary.camera.height, summary.camera.fps);
  text +=
      fmt::format("CAN              {} received, {} sent, {} lost, {} CRC errors, load {:.1f} %\n",
                  summary.can.rx, summary.can.tx, summary.can.lost, summary.can.crc_errors,
                  summary.can.bus_load_percent);
  text += fmt::format("simulation step  {:g} ms, {} overruns\n", Rounded(summary.step.period_ms),
                      summary.step.overruns);
  return text;
}

std::string ModuleName(int module) {
  constexpr std::array<std::string_view, 6> kNames{"none", "flat",    "slope",
                                                   "bomb", "outdoor", "indoor"};
  return std::string(module > 0 && module < 6 ? kNames[static_cast<size_t>(module)] : kNames[0]);
}

std::string AlarmName(int code) {
  constexpr std::array<std::pair<int, std::string_view>, 12> kNames{{{0x10, "collision"},
                                                                     {0x11, "push after alarm"},
                                                                     {0x20, "joint limit"},
                                                                     {0x30, "tilt"},
                                                                     {0x31, "rollover"},
                                                                     {0x40, "bomb touched"},
                                                                     {0x41, "bomb unstable"},
                                                                     {0x42, "detonation"},
                                                                     {0x50, "battery"},
                                                                     {0x60, "link"},
                                                                     {0x70, "box fault"},
                                                                     {0x80, "e-stop"}}};
  for (const auto& [known, name] : kNames) {
    if (known == code) return std::string(name);
  }
  return fmt::format("alarm 0x{:02X}", code);
}

std::string PartNames(uint32_t parts) {
  // Pairs first: people say "front wheels".
  constexpr std::array<std::pair<uint32_t, std::string_view>, 15> kNames{
      {{0b11, "front wheels"},
       {0b1, "front left wheel"},
       {0b10, "front right wheel"},
       {0b1100, "rear wheels"},
       {0b100, "rear left wheel"},
       {0b1000, "rear right wheel"},
       {0b11'0000, "both hands"},
       {1U << 4, "left hand"},
       {1U << 5, "right hand"},
       {1U << 6, "crossbeam"},
       {1U << 7, "chassis"},
       {1U << 8, "big arm"},
       {1U << 9, "small arm"},
       {1U << 10, "mast"},
       {1U << 11, "held bomb"}}};
  std::string text;
  for (const auto& [bits, name] : kNames) {
    if ((parts & bits) != bits) continue;
    parts &= ~bits;
    if (!text.empty()) text += ", ";
    text += name;
  }
  return text;
}

}  // namespace eod::recorder
