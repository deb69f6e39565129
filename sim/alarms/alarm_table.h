#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace eod::sim {

/// Alarm codes of ROB_ALARM.AlarmCode.
enum class AlarmCode : int16_t {
  kCollision = 0x10,
  kPushAfterAlarm = 0x11,
  kJointLimit = 0x20,
  kTilt = 0x30,
  kRollover = 0x31,
  kBombTouched = 0x40,
  kBombUnstable = 0x41,
  kDetonation = 0x42,
  kBattery = 0x50,
  kLink = 0x60,
  kBoxFault = 0x70,
  kEstop = 0x80,
};

/// An alarm went on, went off, or changed its parts.
struct AlarmChange {
  AlarmCode code = AlarmCode::kCollision;
  bool raised = false;
  uint32_t parts = 0;
  bool operator==(const AlarmChange&) const = default;
};

struct ActiveAlarm {
  AlarmCode code = AlarmCode::kCollision;
  uint32_t parts = 0;
  bool operator==(const ActiveAlarm&) const = default;
};

/// The alarms that are on, gravest first: what ends the mission or the robot before what hinders
/// one motion. The box has room for the first one's code.
class AlarmTable {
 public:
  AlarmTable();

  /// Sets whether `code` is on and for which parts; appends to `changes` if that is news. No
  /// allocation here.
  void Set(AlarmCode code, bool on, uint32_t parts, std::vector<AlarmChange>& changes);
  bool IsActive(AlarmCode code) const;
  std::span<const ActiveAlarm> active() const { return active_; }

 private:
  std::vector<ActiveAlarm> active_;
};

}  // namespace eod::sim
