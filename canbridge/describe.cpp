#include "canbridge/describe.h"

#include <fmt/format.h>

#include "dbc/box_codec.h"
#include "dbc/control_map.h"
#include "dbc/database.h"
#include "lcmtypes/channels.h"

namespace eod::bridge {
namespace {

int64_t Milliseconds(Duration duration) { return duration / std::chrono::milliseconds(1); }

std::string DescribeMessages(const dbc::Database& database,
                             const std::map<std::string, dbc::MappedMessage>& messages,
                             std::string_view direction) {
  std::string text;
  for (const auto& [role, mapped] : messages) {
    const dbc::Message* message = database.FindMessage(mapped.message);
    if (message == nullptr) continue;
    const int cycle_ms = message->cycle_time_ms();
    text += fmt::format("  0x{:0{}X}  {:<16} {:>8}  {:<14} {:<12} {}\n", message->id,
                        message->extended ? 8 : 3, message->name,
                        cycle_ms > 0 ? fmt::format("{} ms", cycle_ms) : "event", direction, role,
                        message->e2e_data_id() ? "E2E" : "");
  }
  return text;
}

std::string DescribeChannels(const std::string& prefix) {
  std::string text;
  const auto add = [&](const Channel& channel, std::string_view direction) {
    text += fmt::format("  {:<32} {:<17} {:<5} {}\n", ChannelName(prefix, channel), channel.type,
                        direction, channel.rate);
  };
  add(kBoxCommandChannel, "out");
  add(kLinkStatusChannel, "out");
  add(kAlarmChannel, "both");
  add(kRobotStateChannel, "in");
  add(kMissionStatusChannel, "in");
  add(kTelemetryStateChannel, "in");
  add(kTelemetryAlarmChannel, "in");
  add(kTelemetryMissionChannel, "in");
  return text;
}

}  // namespace

std::string DescribeBridge(const BridgeNodeConfig& node, const std::string& bus_url) {
  const dbc::ControlMap map = dbc::LoadControlMap(node.map_file);
  const dbc::Database database = dbc::LoadDatabase(node.dbc_file);
  const dbc::BoxCodec check(database, map);
  const BridgeConfig& config = node.bridge;
  const SupervisionLimits& limits = config.limits;
  std::string text = fmt::format("bus: {}\ndbc: {}\nmap: {}\n", bus_url, node.dbc_file.string(),
                                 node.map_file.string());
  text += fmt::format("tick: {} ms; lamps on change with a gap of {} ms\n",
                      Milliseconds(config.tick_period), Milliseconds(config.change_gap));
  text += fmt::format(
      "limits: frames {} ms (then to zero in {} ms), latched after {} ms, heartbeat {} ms, "
      "e-stop channels {} ms, simulator {} ms\n",
      Milliseconds(limits.frame_age), Milliseconds(limits.ramp), Milliseconds(limits.latch_age),
      Milliseconds(limits.heartbeat_age), Milliseconds(limits.estop_contradiction),
      Milliseconds(limits.simulator_age));
  text += "CAN messages: id, name, cycle time, direction, role\n";
  text += DescribeMessages(database, map.box_messages, "from box");
  text += DescribeMessages(database, map.robot_messages, "to box");
  text += "LCM channels: name, type, direction, rate\n";
  return text + DescribeChannels(node.channel_prefix);
}

}  // namespace eod::bridge
