#pragma once

#include <string>
#include <vector>

#include <lcm/lcm-cpp.hpp>

#include "eod/alarm_t.hpp"
#include "eod/mission_status_t.hpp"
#include "eod/robot_state_t.hpp"

#include "sim/radio/delay_line.h"

namespace eod::sim {

/// Brings to the operator's side what a real link lets through of the robot's messages, late as it
/// may be: on the telemetry channels. No allocation once its slots have seen the longest message.
class TelemetryNode {
 public:
  /// `lcm` must outlive it; `period` of the steps that send.
  TelemetryNode(const TrafficSpec& spec, int64_t seed, Duration period,
                const std::string& channel_prefix, lcm::LCM& lcm);

  /// The robot sends. `drop`, 0..1: chance that quality takes it, beside the line's own.
  void Send(TimePoint now, const robot_state_t& message, double drop);
  void Send(TimePoint now, const alarm_t& message, double drop);
  void Send(TimePoint now, const mission_status_t& message, double drop);

  /// Publishes what has arrived by `now`; returns how many messages that were.
  uint64_t Deliver(TimePoint now);

 private:
  struct Datagram {
    const std::string* channel = nullptr;
    std::vector<uint8_t> bytes;
  };
  template <typename Message>
  void Encode(TimePoint now, const std::string& channel, const Message& message, double drop);

  lcm::LCM& lcm_;
  std::string state_channel_;
  std::string alarm_channel_;
  std::string mission_channel_;
  DelayLine<Datagram> line_;
};

}  // namespace eod::sim
