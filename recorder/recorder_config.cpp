#include "recorder/recorder_config.h"

#include <fmt/format.h>

#include "lcmtypes/channels.h"

namespace eod::recorder {
namespace {

std::string_view Name(Until until) {
  switch (until) {
    case Until::kMissionEnd:
      return "the mission ends";
    case Until::kScriptDone:
      return "the operator script is done";
    case Until::kSignal:
      break;
  }
  return "interrupted";
}

}  // namespace

std::string Describe(const RecorderConfig& config, const std::string& bus_url) {
  std::string text = fmt::format(
      "eod-recorder: listens only, sends nothing\n"
      "bus              {} ({} bit/s), every frame into {}\n"
      "meaning          {} and {}\n"
      "messages         all channels into {}\n"
      "pictures         one a camera every {:g} s and at alarms into {}\n"
      "at the end       {} and {}\n"
      "records until    {}{}\n"
      "understands\n",
      bus_url, config.bit_rate, (config.out / "can.log").string(), config.dbc_file.string(),
      config.map_file.string(), (config.out / "run.lcmlog").string(), config.picture_period_s,
      (config.out / "camera").string(), (config.out / "summary.json").string(),
      (config.out / "contact_sheet.png").string(), Name(config.until),
      config.seconds > 0 ? fmt::format(", at most {:g} s", config.seconds) : "");
  for (const Channel& channel : kChannels) {
    if (channel.subscribers.find("recorder") == std::string_view::npos) continue;
    text += fmt::format("  {:<24} {:<18} {}\n", ChannelName(config.channel_prefix, channel),
                        channel.type, channel.rate);
  }
  return text;
}

}  // namespace eod::recorder
