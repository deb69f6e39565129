#include "firmware_emu/box_report.h"

#include <array>
#include <string_view>

#include <fmt/format.h>

#include "dbc/control_map.h"
#include "dbc/database.h"
#include "lcmtypes/channels.h"

namespace eod::box {
namespace {

constexpr std::array<std::string_view, dbc::kBoxMessageCount> kRoles{
    "safety", "motion", "axes", "panel", "fire", "heartbeat", "emergency"};

int64_t Milliseconds(Duration duration) {
  return std::chrono::duration_cast<std::chrono::milliseconds>(duration).count();
}

std::string ChannelLine(const BoxNodeConfig& config, const Channel& channel, std::string_view way) {
  return fmt::format("  {:<10} {} ({}, {})\n", way, ChannelName(config.channel_prefix, channel),
                     channel.type, channel.rate);
}

}  // namespace

std::function<void(TimePoint, const std::string&)> PrintTo(std::FILE* out, TimePoint start) {
  return [out, start](TimePoint now, const std::string& text) {
    fmt::print(out, "{:9.3f}  {}\n", ToSeconds(now - start), text);
    std::fflush(out);
  };
}

std::string Describe(const BoxNodeConfig& config, const std::string& bus_url) {
  const dbc::ControlMap map = dbc::LoadControlMap(config.map_file);
  const dbc::BoxCodec codec(dbc::LoadDatabase(config.dbc_file), map);
  std::string text =
      fmt::format("eod-box: emulated control box\nbus        {}\ndbc        {}\nmap        {}\n",
                  bus_url, config.dbc_file.string(), config.map_file.string());
  if (config.script) {
    text += fmt::format("script     {} ({} statements)\n", config.script->file.string(),
                        config.script->statements.size());
  }
  text +=
      fmt::format("tick       1 ms\nlink lost  {} ms without a valid robot frame\nframes sent\n",
                  Milliseconds(config.box.link_timeout));
  for (int i = 0; i < dbc::kBoxMessageCount; ++i) {
    const auto role = static_cast<dbc::BoxMessage>(i);
    const auto message = map.box_messages.find(std::string(kRoles[i]));
    if (message == map.box_messages.end()) continue;
    const Duration cycle = codec.cycle_time(role);
    text += cycle == Duration::zero()
                ? fmt::format("  {:<14} on events\n", message->second.message)
                : fmt::format("  {:<14} every {} ms, offset {} ms\n", message->second.message,
                              Milliseconds(cycle), Milliseconds(TransmitSchedule::Offset(role)));
  }
  return text + "LCM channels\n" + ChannelLine(config, kPanelCommandChannel, "subscribes") +
         ChannelLine(config, kPanelStatusChannel, "publishes");
}

}  // namespace eod::box
