#include "sim/telemetry_node.h"

#include "lcmtypes/channels.h"

namespace eod::sim {
namespace {

constexpr size_t kUsualBytes = 1024;  // of the longest message
constexpr size_t kBesideStates = 64;  // alarms and missions under way

/// As many messages as can be under way.
size_t Capacity(const TrafficSpec& spec, Duration period) {
  return kBesideStates + static_cast<size_t>(1.1 * (spec.delay + spec.jitter) / ToSeconds(period));
}

}  // namespace

TelemetryNode::TelemetryNode(const TrafficSpec& spec, int64_t seed, Duration period,
                             const std::string& channel_prefix, lcm::LCM& lcm)
    : lcm_(lcm),
      state_channel_(ChannelName(channel_prefix, kTelemetryStateChannel)),
      alarm_channel_(ChannelName(channel_prefix, kTelemetryAlarmChannel)),
      mission_channel_(ChannelName(channel_prefix, kTelemetryMissionChannel)),
      line_(spec, seed, LinkStream::kTelemetry, Capacity(spec, period)) {
  line_.ForEachSlot([](Datagram& datagram) { datagram.bytes.reserve(kUsualBytes); });
}

void TelemetryNode::Send(TimePoint now, const robot_state_t& message, double drop) {
  Encode(now, state_channel_, message, drop);
}

void TelemetryNode::Send(TimePoint now, const alarm_t& message, double drop) {
  Encode(now, alarm_channel_, message, drop);
}

void TelemetryNode::Send(TimePoint now, const mission_status_t& message, double drop) {
  Encode(now, mission_channel_, message, drop);
}

template <typename Message>
void TelemetryNode::Encode(TimePoint now, const std::string& channel, const Message& message,
                           double drop) {
  Datagram* datagram = line_.Send(now, drop);
  if (datagram == nullptr) return;
  datagram->channel = &channel;
  datagram->bytes.resize(static_cast<size_t>(message.getEncodedSize()));
  message.encode(datagram->bytes.data(), 0, static_cast<int>(datagram->bytes.size()));
}

uint64_t TelemetryNode::Deliver(TimePoint now) {
  uint64_t delivered = 0;
  while (const Datagram* datagram = line_.Receive(now)) {
    lcm_.publish(*datagram->channel, datagram->bytes.data(),
                 static_cast<unsigned>(datagram->bytes.size()));
    ++delivered;
  }
  return delivered;
}

}  // namespace eod::sim
