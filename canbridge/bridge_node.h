#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <lcm/lcm-cpp.hpp>

#include "eod/alarm_t.hpp"
#include "eod/box_command_t.hpp"
#include "eod/link_status_t.hpp"
#include "eod/mission_status_t.hpp"
#include "eod/robot_state_t.hpp"

#include "canbridge/bridge.h"
#include "dbc/control_map.h"
#include "platform/can_bus.h"
#include "platform/clock.h"

namespace eod::bridge {

struct BridgeNodeConfig {
  std::filesystem::path dbc_file;
  std::filesystem::path map_file;
  std::string channel_prefix;
  BridgeConfig bridge;
};

/// The bridge on its bus and its LCM network: box_command_t, link_status_t and the bridge's alarm_t
/// out; robot_state_t, the simulator's alarm_t and mission_status_t in, as the link to the robot
/// brings them.
class BridgeNode {
 public:
  /// `bus`, `lcm` and `clock` must outlive the node. Throws std::runtime_error with one line for a
  /// DBC or map that does not load.
  BridgeNode(const BridgeNodeConfig& config, CanBus& bus, lcm::LCM& lcm, const Clock& clock);
  ~BridgeNode();
  BridgeNode(const BridgeNode&) = delete;
  BridgeNode& operator=(const BridgeNode&) = delete;

  /// Takes all frames that wait on the bus.
  void OnCan();
  void OnTick(TimePoint scheduled);
  Duration tick_period() const { return config_.bridge.tick_period; }

  const Bridge& bridge() const { return bridge_; }
  /// Messages sent on LCM so far.
  uint64_t published() const { return published_; }

 private:
  void OnRobotState(const lcm::ReceiveBuffer* buffer, const std::string& channel,
                    const robot_state_t* message);
  void OnAlarm(const lcm::ReceiveBuffer* buffer, const std::string& channel,
               const alarm_t* message);
  void OnMission(const lcm::ReceiveBuffer* buffer, const std::string& channel,
                 const mission_status_t* message);
  void OnTelemetryState(const lcm::ReceiveBuffer* buffer, const std::string& channel,
                        const robot_state_t* message);
  void OnTelemetryAlarm(const lcm::ReceiveBuffer* buffer, const std::string& channel,
                        const alarm_t* message);
  void OnTelemetryMission(const lcm::ReceiveBuffer* buffer, const std::string& channel,
                          const mission_status_t* message);

  void Emit(TimePoint now, const BridgeOutput& output);
  void Publish(TimePoint now, const BoxCommand& command);
  void Publish(TimePoint now, const LinkStatus& link);
  void PublishAlarm(TimePoint now, const AlarmChange* change,
                    const std::vector<ActiveAlarm>& active);

  BridgeNodeConfig config_;
  CanBus& bus_;
  lcm::LCM& lcm_;
  const Clock& clock_;
  dbc::ControlMap map_;
  Bridge bridge_;
  std::array<lcm::Subscription*, 6> subscriptions_{};
  std::string command_channel_;
  std::string link_channel_;
  std::string alarm_channel_;
  int32_t command_sequence_ = 0;
  int32_t alarm_sequence_ = 0;
  uint64_t published_ = 0;
  bool was_silent_ = false;
};

}  // namespace eod::bridge
