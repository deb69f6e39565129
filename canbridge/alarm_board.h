#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "canbridge/bridge_messages.h"
#include "dbc/control_map.h"
#include "dbc/robot_feedback.h"

namespace eod::bridge {

/// What the active alarms do on the box.
struct AlarmDisplay {
  int code = 0;            ///< of the alarm with the highest priority, 0 without one
  uint32_t hit_parts = 0;  ///< parts that touch something, and those of the displayed alarm
  dbc::BuzzerPattern buzzer = dbc::BuzzerPattern::kOff;
  std::array<dbc::LampPattern, dbc::kLampCount> lamp{};  ///< indexed by dbc::Lamp; kOff: no alarm

  bool operator==(const AlarmDisplay&) const = default;
};

/// The alarms of simulator and bridge together, and what the map makes of them.
///
/// The displayed alarm owns the buzzer; every alarm lights its lamp, the higher priority winning a
/// shared one. Alarms that the map does not name stay off the box.
class AlarmBoard {
 public:
  /// `map` must outlive this object.
  explicit AlarmBoard(const dbc::ControlMap& map);

  void SetSimulatorAlarms(std::span<const ActiveAlarm> active);
  void SetBridgeAlarms(std::span<const ActiveAlarm> active);
  /// Silences the buzzer until an alarm comes that was not active.
  void Acknowledge();

  const AlarmDisplay& display() const { return display_; }

 private:
  void Replace(std::vector<ActiveAlarm>& set, std::span<const ActiveAlarm> active);
  bool IsActive(int code) const;
  void Refresh();

  const dbc::ControlMap& map_;
  std::vector<ActiveAlarm> simulator_;
  std::vector<ActiveAlarm> bridge_;
  bool is_silenced_ = false;
  AlarmDisplay display_;
};

}  // namespace eod::bridge
